#include "core/body/measure/tape.h"

#include <algorithm>
#include <cmath>

#include "core/body/measure/cut_points.h"
#include "core/geometry/convex_hull.h"

namespace toile::measure {
namespace {

constexpr double kScanStep = 0.004;      // m
constexpr double kWiderThanRibs = 1.12;  // a chest's breadth over that of the ribs below it, at most

// What the tape goes around in the level plane at `height`, as (x, z).
std::vector<Vec2> middle_points(const geometry::TriangleMesh& mesh, double height) {
  return flat(middle_points(plane_cut(mesh, {0, height, 0}, {0, 1, 0}), 0));
}

// The part of a convex polygon on which side·x <= limit. Cut, not dropped: a girth must not jump as a point
// passes the limit.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, double limit, double side) {
  std::vector<Vec2> out;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double da = side * a.x - limit, db = side * b.x - limit;
    if (da <= 0) out.push_back(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) out.push_back(a + (b - a) * (da / (da - db)));
  }
  return out;
}

template <typename Better>
Girth best_girth(const geometry::TriangleMesh& mesh, double low, double high, double half_breadth,
                 Better better) {
  Girth best{low, girth_at(mesh, low, half_breadth)};
  const int steps = static_cast<int>(std::ceil((high - low) / kScanStep));
  for (int i = 1; i <= steps; ++i) {
    const double y = low + (high - low) * i / steps;
    const double g = girth_at(mesh, y, half_breadth);
    if (better(g, best.girth)) best = {y, g};
  }
  return best;
}

}  // namespace

double girth_at(const geometry::TriangleMesh& mesh, double height, double half_breadth) {
  std::vector<Vec2> around = geometry::convex_hull(middle_points(mesh, height));
  if (half_breadth < kNoBreadth) around = clipped(clipped(around, half_breadth, 1), half_breadth, -1);
  return geometry::perimeter(around);
}

double half_breadth_at(const geometry::TriangleMesh& mesh, double height) {
  double most = 0;
  for (const Vec2& p : middle_points(mesh, height)) most = std::max(most, std::abs(p.x));
  return most;
}

Girth narrowest_girth(const geometry::TriangleMesh& mesh, double low, double high, double half_breadth) {
  return best_girth(mesh, low, high, half_breadth, [](double a, double b) { return a < b; });
}

Girth widest_girth(const geometry::TriangleMesh& mesh, double low, double high, double half_breadth) {
  return best_girth(mesh, low, high, half_breadth, [](double a, double b) { return a > b; });
}

TrunkGirths trunk_girths(const geometry::TriangleMesh& standing) {
  double h = 0;
  for (const Vec3& p : standing.vertices) h = std::max(h, p.y);
  // Shares of the stature: see trunk_girths in the header.
  const double ribs = kWiderThanRibs * half_breadth_at(standing, 0.68 * h);
  return {widest_girth(standing, 0.70 * h, 0.72 * h, ribs), narrowest_girth(standing, 0.58 * h, 0.68 * h),
          widest_girth(standing, 0.48 * h, 0.56 * h)};
}

}  // namespace toile::measure
