#include "core/body/measure/cut_points.h"

#include <algorithm>
#include <cmath>

#include "core/base/aabb.h"
#include "core/geometry/convex_hull.h"

namespace toile::measure {

std::vector<Vec2> flat(const std::vector<Vec3>& points) {
  std::vector<Vec2> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.push_back({p.x, p.z});
  return out;
}

// The parts of a level cut across the middle, or else the nearest on each side.
std::vector<Vec3> middle_points(const MeshCut& cut, double middle) {
  std::vector<double> low(cut.part_count, HUGE_VAL), high(cut.part_count, -HUGE_VAL);
  for (size_t i = 0; i < cut.points.size(); ++i) {
    const double x = cut.points[i].x - middle;
    double &l = low[cut.part[i]], &h = high[cut.part[i]];
    l = std::min(l, x);
    h = std::max(h, x);
  }
  std::vector<bool> chosen(cut.part_count, false);
  bool any = false;
  Index left = kNone, right = kNone;
  for (Index k = 0; k < cut.part_count; ++k) {
    if (low[k] <= 0 && high[k] >= 0) chosen[k] = any = true;
    if (low[k] > 0 && (left == kNone || low[k] < low[left])) left = k;
    if (high[k] < 0 && (right == kNone || high[k] > high[right])) right = k;
  }
  for (Index k : {left, right})
    if (!any && k != kNone) chosen[k] = true;
  std::vector<Vec3> out;
  for (size_t i = 0; i < cut.points.size(); ++i)
    if (chosen[cut.part[i]]) out.push_back(cut.points[i]);
  return out;
}

Vec3 middle_of(const std::vector<Vec3>& points) {
  Aabb3 box;
  for (const Vec3& p : points) box.add(p);
  return box.middle();
}

// The outermost part of a cut among those whose middle lies within reach of p: the arm, not the trunk beside
// it.
std::vector<Vec3> outer_part(const MeshCut& cut, Vec3 p, double reach) {
  std::vector<std::vector<Vec3>> parts(cut.part_count);
  for (size_t i = 0; i < cut.points.size(); ++i) parts[cut.part[i]].push_back(cut.points[i]);
  std::vector<Vec3> best;
  double most = -HUGE_VAL;
  for (std::vector<Vec3>& points : parts) {
    if (points.size() < 3) continue;
    const Vec3 middle = middle_of(points);
    if (length(middle - p) < reach && middle.x > most) {
      most = middle.x;
      best = std::move(points);
    }
  }
  return best;
}

namespace {

struct Axes {
  Vec3 u, v;
};

Axes axes_of(Vec3 normal) {
  // Any two axes in the plane do; this one is never nearly along the normal.
  const Vec3 side = std::abs(normal.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = normalized(cross(side, normal));
  return {u, cross(normal, u)};
}

std::vector<Vec2> in_plane(const std::vector<Vec3>& points, const Axes& axes) {
  std::vector<Vec2> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.push_back({dot(p, axes.u), dot(p, axes.v)});
  return out;
}

}  // namespace

std::vector<Vec3> taut_loop(const std::vector<Vec3>& points, Vec3 normal) {
  std::vector<Vec3> out;
  if (points.empty()) return out;
  const Axes axes = axes_of(normal);
  const Vec3 off = normal * dot(points.front(), normal);
  for (const Vec2& p : geometry::convex_hull(in_plane(points, axes)))
    out.push_back(axes.u * p.x + axes.v * p.y + off);
  return out;
}

double around(const std::vector<Vec3>& points, Vec3 normal) {
  return geometry::hull_perimeter(in_plane(points, axes_of(normal)));
}

}  // namespace toile::measure
