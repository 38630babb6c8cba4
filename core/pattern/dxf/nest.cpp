#include "core/pattern/dxf/nest.h"

#include <algorithm>
#include <cmath>

namespace toile::dxf {
namespace {

constexpr double kSameArea = 1e-3;  // share by which two drawings of one outline may differ

}  // namespace

double distance_to_loop(Vec2 p, const std::vector<Vec2>& loop) {
  double nearest = length(loop[0] - p);
  for (std::size_t i = 0, n = loop.size(); i < n; ++i)
    nearest = std::min(nearest, geometry::distance_to_segment(p, loop[i], loop[(i + 1) % n]));
  return nearest;
}

DxfLoop loop_of(const DxfChain& chain, std::size_t number, DxfRole role) {
  return {&chain, number, role, bounding_box(chain.points), std::abs(geometry::signed_area(chain.points)),
          {},     0};
}

bool lies_within(const DxfLoop& inner, const DxfLoop& outer) {
  if (inner.area >= outer.area || !outer.box.contains(inner.box)) return false;
  if (!geometry::contains(outer.chain->points, inner.chain->points[0])) return false;
  const std::vector<std::vector<Vec2>> both{inner.chain->points, outer.chain->points};
  // A loop that crosses itself is found later, with a better message; here only their meeting counts.
  const std::optional<geometry::Crossing> crossing = geometry::find_crossing(both);
  return !crossing || crossing->loop_a == crossing->loop_b;
}

std::vector<DxfLoop> nested(std::vector<DxfLoop> loops) {
  std::vector<std::size_t> by_area(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) by_area[i] = i;
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](auto a, auto b) { return loops[a].area < loops[b].area; });
  for (std::size_t k = by_area.size(); k-- > 0;) {
    DxfLoop& inner = loops[by_area[k]];
    for (std::size_t m = k + 1; m < by_area.size() && !inner.parent; ++m) {
      const DxfLoop& outer = loops[by_area[m]];
      if (outer.chain->layer != inner.chain->layer || !lies_within(inner, outer)) continue;
      inner.parent = by_area[m];
      inner.depth = outer.depth + 1;
    }
  }
  return loops;
}

bool is_covered(const DxfLoop& inner, const DxfLoop& outer) {
  constexpr double kAlong = 0.1;  // mm from the outline
  constexpr std::size_t kSamples = 200;
  if (!outer.box.grown(kAlong).contains(inner.box)) return false;
  const std::vector<Vec2>& points = inner.chain->points;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / kSamples)
    if (!geometry::contains(outer.chain->points, points[i]) &&
        distance_to_loop(points[i], outer.chain->points) > kAlong)
      return false;
  return true;
}

bool lies_mostly_within(const DxfLoop& inner, const DxfLoop& outer) {
  constexpr std::size_t kSamples = 50;
  const std::vector<Vec2>& points = inner.chain->points;
  std::size_t inside = 0, asked = 0;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / kSamples, ++asked)
    inside += geometry::contains(outer.chain->points, points[i]) ? 1 : 0;
  return 2 * inside > asked;
}

bool same_place(const Aabb2& a, const Aabb2& b) {
  return a.grown(kBoxSlack).contains(b) || b.grown(kBoxSlack).contains(a);
}

bool is_repeated(const DxfLoop& a, const DxfLoop& b) {
  return std::abs(a.area - b.area) <= kSameArea * std::max(a.area, b.area) && same_place(a.box, b.box);
}

}  // namespace toile::dxf
