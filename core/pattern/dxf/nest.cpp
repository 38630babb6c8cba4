#include "core/pattern/dxf/nest.h"

#include <algorithm>
#include <cmath>

namespace toile::dxf {
namespace {

constexpr double kSameArea = 1e-3;  // share by which two drawings of one outline may differ

double distance_to_loop(Vec2 p, const std::vector<Vec2>& loop) {
  double nearest = length(loop[0] - p);
  for (std::size_t i = 0, n = loop.size(); i < n; ++i)
    nearest = std::min(nearest, geometry::distance_to_segment(p, loop[i], loop[(i + 1) % n]));
  return nearest;
}

/// Points at even distances along the loop.
std::vector<Vec2> samples(const std::vector<Vec2>& loop, std::size_t count) {
  const double step = (geometry::polyline_length(loop) + length(loop.front() - loop.back())) / double(count);
  std::vector<Vec2> points;
  double next = step / 2, walked = 0;
  for (std::size_t i = 0, n = loop.size(); i < n && points.size() < count; ++i) {
    const Vec2 a = loop[i], b = loop[(i + 1) % n];
    const double l = length(b - a);
    while (l > 0 && next <= walked + l && points.size() < count) {
      points.push_back(a + (b - a) * ((next - walked) / l));
      next += step;
    }
    walked += l;
  }
  return points;
}

/// Distances of one loop's samples from the other, ascending.
std::vector<double> distances(const DxfLoop& from, const DxfLoop& to) {
  constexpr std::size_t kSamples = 64;
  std::vector<double> all;
  for (const Vec2 p : samples(from.chain->points, kSamples))
    all.push_back(distance_to_loop(p, to.chain->points));
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

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

bool same_place(const Aabb2& a, const Aabb2& b) {
  return a.grown(kBoxSlack).contains(b) || b.grown(kBoxSlack).contains(a);
}

bool is_repeated(const DxfLoop& a, const DxfLoop& b) {
  return std::abs(a.area - b.area) <= kSameArea * std::max(a.area, b.area) && same_place(a.box, b.box);
}

bool is_seam_line(const DxfLoop& inner, const DxfLoop& outer) {
  constexpr double kNarrowest = 2.5, kWidest = 45;  // mm, of the allowance on most of the way
  constexpr double kHem = 80;                       // mm, the widest anywhere
  constexpr double kCorner = 1.5;                   // times that at the outer corners
  constexpr double kAlike = 0.35;                   // share by which allowances may differ …
  constexpr double kMostly = 0.6;                   // … on this share of the way
  if (inner.area < outer.area * 0.15 || !is_covered(inner, outer)) return false;
  const std::vector<double> in = distances(inner, outer), out = distances(outer, inner);
  const double median = in[in.size() / 2];
  if (median < kNarrowest || median > kWidest || in.back() > kHem || out.back() > kCorner * kHem)
    return false;
  const auto alike =
      std::count_if(in.begin(), in.end(), [&](double d) { return std::abs(d - median) <= kAlike * median; });
  return double(alike) >= kMostly * double(in.size());
}

}  // namespace toile::dxf
