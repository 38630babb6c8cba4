#include "core/arrange/leg_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace toile::arrange {

namespace {

constexpr double kSameCrotch = 0.02;  // of their length, by which two crotch lines differ that tell no side

bool is_closed_leg(const GarmentPiece& piece) { return piece.tube && piece.cover == Cover::kLeg; }

/// The stitches that join the piece to other legs, m, in its plane.
std::vector<Vec2> crotch_of(const GarmentGraph& graph, Index p) {
  std::vector<Vec2> crotch;
  for (const GarmentTie& t : graph.ties) {
    if (t.a == t.b || (t.a != p && t.b != p)) continue;
    if (is_closed_leg(graph.pieces[t.a == p ? t.b : t.a])) crotch.push_back(t.a == p ? t.at_a : t.at_b);
  }
  return crotch;
}

/// Length of the line through points in the order of their heights along `up`, m.
double run_of(std::vector<Vec2> points, Vec2 up) {
  std::sort(points.begin(), points.end(), [&](Vec2 a, Vec2 b) { return dot(a, up) < dot(b, up); });
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
  return sum;
}

/// -1 where the crotch's front lies towards smaller u with `up` upwards, seen from outside, 1 towards larger;
/// 0 where both lines are alike.
int front_of(const std::vector<Vec2>& crotch, const LegPiece& leg) {
  const Vec2 aside = perpendicular(leg.up) * -1;  // u
  std::array<std::vector<Vec2>, 2> lines;
  for (const Vec2 q : crotch) lines[dot(q - leg.fork, aside) > 0 ? 1 : 0].push_back(q);
  const double low = run_of(lines[0], leg.up), high = run_of(lines[1], leg.up);
  if (std::abs(low - high) < kSameCrotch * std::max(low, high)) return 0;
  return low < high ? -1 : 1;
}

std::optional<LegPiece> measured(const GarmentGraph& graph, Index p, const std::vector<Vec2>& crotch) {
  std::vector<std::array<Vec2, 2>> seam;
  for (const GarmentTie& t : graph.ties)
    if (t.a == p && t.b == p) seam.push_back({t.at_a, t.at_b});
  const auto middle = [](const std::array<Vec2, 2>& pair) { return (pair[0] + pair[1]) * 0.5; };
  Vec2 above;
  for (const Vec2 q : crotch) above = above + q * (1.0 / static_cast<double>(crotch.size()));
  const auto [upper, lower] = std::minmax_element(
      seam.begin(), seam.end(),
      [&](const auto& a, const auto& b) { return length(middle(a) - above) < length(middle(b) - above); });
  LegPiece leg;
  leg.piece = p;
  leg.fork = middle(*upper);
  leg.length = length(leg.fork - middle(*lower));
  if (!(leg.length > 0)) return std::nullopt;
  leg.up = normalized(leg.fork - middle(*lower));
  leg.at_fork = length((*upper)[1] - (*upper)[0]);
  leg.at_hem = length((*lower)[1] - (*lower)[0]);
  return leg;
}

}  // namespace

std::vector<LegPiece> leg_pieces(const GarmentGraph& graph) {
  std::vector<LegPiece> legs;
  for (Index p = 0; p < static_cast<Index>(graph.pieces.size()); ++p) {
    if (!is_closed_leg(graph.pieces[p])) continue;
    const std::vector<Vec2> crotch = crotch_of(graph, p);
    if (crotch.empty()) continue;
    std::optional<LegPiece> leg = measured(graph, p, crotch);
    if (!leg) continue;
    int hand = -front_of(crotch, *leg) * graph.pieces[p].outside;
    if (hand == 0) hand = graph.pieces[p].hand;
    if (hand == 0) hand = legs.size() % 2 == 0 ? 1 : -1;
    leg->side = hand > 0 ? measure::kWearersLeft : measure::kWearersRight;
    legs.push_back(*leg);
  }
  return legs;
}

}  // namespace toile::arrange
