// Trousers on legs that stand as they do.

#include <algorithm>
#include <cmath>

#include "core/arrange/arranger.h"

namespace toile {

namespace {

constexpr double kMostTurned = 0.2;   ///< radians
constexpr double kFromMiddle = 0.01;  ///< m, inner edges stay so far from the mid-plane
constexpr double kHem = 0.03;         ///< m, what lies that near the lowest point is the hem

double sign_of(double x) { return x >= 0 ? 1 : -1; }

}  // namespace

/// Where on the sheet the piece's inner leg seam begins.
std::optional<Vec2> Arranger::top_of_inner_seam(Index piece) const {
  std::optional<Vec2> highest;
  const double middle = std::abs(layout_.pose[piece](graph_.pieces[piece].centroid).x);
  for (const GarmentTie& t : graph_.ties) {
    const bool first = t.a == piece;
    if ((!first && t.b != piece) || !layout_.has(t.a) || !layout_.has(t.b)) continue;
    const Index other = first ? t.b : t.a;
    if (graph_.pieces[other].cover != Cover::kLeg || layout_.face[other] == layout_.face[piece]) continue;
    const Vec2 at = layout_.pose[piece](first ? t.at_a : t.at_b);
    if (std::abs(at.x) < middle && (!highest || at.y > highest->y)) highest = at;
  }
  return highest;
}

/// Turns the pieces of each leg about the top of their inner seam until the hem hangs over the ankle: cut
/// legs spread as the crotch curve has it, and threads of hems that stand beside the feet would catch on
/// them.
void Arranger::set_legs_over_legs() {
  for (const Index p : trunk_) {
    if (graph_.pieces[p].cover != Cover::kLeg || !layout_.has(p)) continue;
    const std::optional<Vec2> pivot = top_of_inner_seam(p);
    if (!pivot) continue;
    const std::vector<Vec2> outline = outline_on_sheet(graph_.pieces[p], layout_.pose[p]);
    const auto low =
        std::min_element(outline.begin(), outline.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
    double inner = HUGE_VAL, outer = -HUGE_VAL;
    const double side = sign_of(layout_.pose[p](graph_.pieces[p].centroid).x);
    for (const Vec2 q : outline) {
      if (q.y < low->y + kHem) {
        inner = std::min(inner, side * q.x);
        outer = std::max(outer, side * q.x);
      }
    }
    const double drop = pivot->y - low->y;
    const LegLine& leg = stand_.figure().leg[side > 0 ? kWearersLeft : kWearersRight];
    const double below = std::min(drop, stand_.figure().crotch - leg.ankle.y);
    if (!(below > 0.1)) continue;
    const double share = below / (leg.top.y - leg.ankle.y);
    const double wanted =
        side * (leg.top.x + (leg.ankle.x - leg.top.x) * std::min(1.0, share) - stand_.figure().middle);
    const double shift = std::max(wanted - (inner + outer) / 2, kFromMiddle - inner);
    const double turn = std::clamp(shift / drop, -kMostTurned, kMostTurned);
    const FlatMove about = turn_by(side * turn, false);
    FlatMove move = about;
    move.t = *pivot - about.turned(*pivot);
    layout_.pose[p] = after(move, layout_.pose[p]);
  }
}

}  // namespace toile
