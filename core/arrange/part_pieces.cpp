#include <algorithm>
#include <cmath>

#include "core/arrange/flat_layout.h"
#include "core/geometry/polygon2.h"

namespace toile::arrange {

namespace {

/// Whether two outlines lie in each other or are nearer than `gap`.
bool too_near(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double gap) {
  const Aabb2 box_a = bounding_box(a).grown(gap), box_b = bounding_box(b);
  if (box_a.low.x > box_b.high.x || box_b.low.x > box_a.high.x || box_a.low.y > box_b.high.y ||
      box_b.low.y > box_a.high.y)
    return false;
  const auto near_one = [&](const std::vector<Vec2>& points, const std::vector<Vec2>& loop) {
    return std::any_of(points.begin(), points.end(), [&](Vec2 p) {
      if (geometry::contains(loop, p)) return true;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (geometry::distance_to_segment(p, loop[i], loop[(i + 1) % loop.size()]) < gap) return true;
      }
      return false;
    });
  };
  return near_one(a, b) || near_one(b, a);
}

/// Upwards, downwards or sideways, as the two lie to each other.
Vec2 way_apart(const Aabb2& a, const Aabb2& b) {
  const Vec2 d = b.middle() - a.middle();
  const Vec2 room = (a.size() + b.size()) * 0.5;
  const bool sideways = std::abs(d.x) / std::max(room.x, 1e-6) >= std::abs(d.y) / std::max(room.y, 1e-6);
  return sideways ? Vec2{d.x < 0 ? -1.0 : 1.0, 0} : Vec2{0, d.y < 0 ? -1.0 : 1.0};
}

}  // namespace

void part_pieces(const GarmentGraph& graph, const std::vector<Index>& members, double gap,
                 FlatLayout& layout) {
  constexpr double kStep = 2e-3;
  constexpr int kRounds = 75;
  const auto move = [&](Index p, Vec2 by) {
    const Index partner = layout.partner[p];
    if (partner == p) by.x = 0;
    layout.pose[p].t = layout.pose[p].t + by;
    if (partner != kNone && partner != p) layout.pose[partner].t = layout.pose[partner].t + Vec2{-by.x, by.y};
  };
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (std::size_t j = i + 1; j < members.size(); ++j) {
        const Index p = members[i], q = members[j];
        if (!layout.has(p) || layout.face[p] != layout.face[q]) continue;
        const auto a = outline_on_sheet(graph.pieces[p], layout.pose[p]);
        const auto b = outline_on_sheet(graph.pieces[q], layout.pose[q]);
        if (!too_near(a, b, gap)) continue;
        const Vec2 way = way_apart(bounding_box(a), bounding_box(b)) * kStep;
        if (layout.partner[p] == q) {
          move(p,
               {way.x == 0 ? (layout.pose[p](graph.pieces[p].centroid).x < 0 ? -kStep : kStep) : -way.x, 0});
        } else {
          move(p, -way);
          move(q, way);
        }
        moved = true;
      }
    }
    if (!moved) return;
  }
}

}  // namespace toile::arrange
