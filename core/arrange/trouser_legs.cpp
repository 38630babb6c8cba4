#include "core/arrange/trouser_legs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace toile::arrange {

namespace {

constexpr double kMostTurned = 0.2;   ///< radians
constexpr double kFromMiddle = 0.01;  ///< m, inner edges stay so far from the mid-plane
constexpr double kHem = 0.03;         ///< m, what lies that near the lowest point is the hem

double sign_of(double x) { return x >= 0 ? 1 : -1; }

/// Where on the sheet the piece's inner leg seam begins.
std::optional<Vec2> top_of_inner_seam(const GarmentGraph& graph, const FlatLayout& layout, Index piece) {
  std::optional<Vec2> highest;
  const double middle = std::abs(layout.pose[piece](graph.pieces[piece].centroid).x);
  for (const GarmentTie& t : graph.ties) {
    const bool first = t.a == piece;
    if ((!first && t.b != piece) || !layout.has(t.a) || !layout.has(t.b)) continue;
    const Index other = first ? t.b : t.a;
    if (graph.pieces[other].cover != Cover::kLeg || layout.face[other] == layout.face[piece]) continue;
    const Vec2 at = layout.pose[piece](first ? t.at_a : t.at_b);
    if (std::abs(at.x) < middle && (!highest || at.y > highest->y)) highest = at;
  }
  return highest;
}

/// How the leg piece is to turn, on the sheet; nothing where it has no inner seam or ends above the legs.
std::optional<FlatMove> move_over_leg(const GarmentGraph& graph, const FlatLayout& layout, Index p,
                                      const BodyStand& stand) {
  const std::optional<Vec2> pivot = top_of_inner_seam(graph, layout, p);
  if (!pivot) return std::nullopt;
  const std::vector<Vec2> outline = outline_on_sheet(graph.pieces[p], layout.pose[p]);
  const auto low = std::min_element(outline.begin(), outline.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
  double inner = HUGE_VAL, outer = -HUGE_VAL;
  const double side = sign_of(layout.pose[p](graph.pieces[p].centroid).x);
  for (const Vec2 q : outline) {
    if (q.y < low->y + kHem) {
      inner = std::min(inner, side * q.x);
      outer = std::max(outer, side * q.x);
    }
  }
  const double drop = pivot->y - low->y;
  const measure::LegLine& leg = stand.figure().leg[side > 0 ? measure::kWearersLeft : measure::kWearersRight];
  const double below = std::min(drop, stand.figure().crotch - leg.ankle.y);
  if (!(below > 0.1)) return std::nullopt;
  const double share = below / (leg.top.y - leg.ankle.y);
  const double wanted =
      side * (leg.top.x + (leg.ankle.x - leg.top.x) * std::min(1.0, share) - stand.figure().middle);
  const double shift = std::max(wanted - (inner + outer) / 2, kFromMiddle - inner);
  const double turn = std::clamp(shift / drop, -kMostTurned, kMostTurned);
  const FlatMove about = turn_by(side * turn, false);
  FlatMove move = about;
  move.t = *pivot - about.turned(*pivot);
  return move;
}

/// What hangs from the leg piece on its sheet and goes where it goes: its cuff, and the frill of that.
std::vector<Index> hangs_from(const GarmentGraph& graph, const FlatLayout& layout, Index leg) {
  std::vector<Index> hanging{leg};
  for (std::size_t k = 0; k < hanging.size(); ++k) {
    for (const GarmentTie& t : graph.ties) {
      if (t.a != hanging[k] && t.b != hanging[k]) continue;
      const Index other = t.a == hanging[k] ? t.b : t.a;
      if (graph.pieces[other].cover != Cover::kCuff || !layout.has(other)) continue;
      if (layout.face[other] != layout.face[leg]) continue;
      if (std::find(hanging.begin(), hanging.end(), other) == hanging.end()) hanging.push_back(other);
    }
  }
  hanging.erase(hanging.begin());
  return hanging;
}

}  // namespace

FlatLayout with_legs_over_legs(const GarmentGraph& graph, const std::vector<Index>& members,
                               const BodyStand& stand, FlatLayout layout) {
  for (const Index p : members) {
    if (graph.pieces[p].cover != Cover::kLeg || !layout.has(p)) continue;
    const auto move = move_over_leg(graph, layout, p, stand);
    if (!move) continue;
    layout.pose[p] = after(*move, layout.pose[p]);
    for (const Index cuff : hangs_from(graph, layout, p)) layout.pose[cuff] = after(*move, layout.pose[cuff]);
  }
  return layout;
}

}  // namespace toile::arrange
