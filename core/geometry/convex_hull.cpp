#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <utility>

namespace toile::geometry {

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;
  std::vector<Vec2> out;
  // A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing
  // Letters 9, 1979. Points on a side are left out, for the perimeter does not see them.
  for (int pass = 0; pass < 2; ++pass) {  // lower chain, then upper
    const size_t base = out.size() + 1;
    for (const Vec2& p : points) {
      while (out.size() > base && cross(out.back() - out[out.size() - 2], p - out.back()) <= 0)
        out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return out;
}

double perimeter(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i) sum += length(polygon[(i + 1) % polygon.size()] - polygon[i]);
  return sum;
}

double hull_perimeter(std::vector<Vec2> points) { return perimeter(convex_hull(std::move(points))); }

}  // namespace toile::geometry
