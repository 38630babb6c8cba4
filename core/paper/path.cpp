#include "core/paper/path.h"

namespace toile::paper {

namespace {

/// Of a triangle's weights. Neighbours overlap by so much: a path that meets their common edge meets one.
constexpr double kOnBorder = 1e-9;

Corners between(const Corners& before, const Corners& after, double t) {
  Corners c;
  for (int k = 0; k < 3; ++k) c[k] = before[k] + (after[k] - before[k]) * t;
  return c;
}

}  // namespace

std::optional<std::array<double, 3>> inside(const Corners& triangle, Vec3 p) {
  const Vec3 n = area_normal(triangle);
  const double whole = dot(n, n);
  if (!(whole > 0)) return std::nullopt;
  std::array<double, 3> share{};
  for (int k = 0; k < 3; ++k) {
    const Vec3 a = triangle[(k + 1) % 3], b = triangle[(k + 2) % 3];
    share[k] = dot(cross(b - a, p - a), n) / whole;
    if (share[k] < -kOnBorder) return std::nullopt;
  }
  return share;
}

std::optional<PathHit> path_hit(Vec3 p0, Vec3 p1, const Corners& before, const Corners& after) {
  const Vec3 n0 = normalized(area_normal(before)), n1 = normalized(area_normal(after));
  const double d0 = dot(n0, p0 - before[0]), d1 = dot(n1, p1 - after[0]);
  if (!(d0 > 0 && d1 <= 0) && !(d0 < 0 && d1 >= 0)) return std::nullopt;
  const double t = d0 / (d0 - d1);
  const auto share = inside(between(before, after, t), p0 + (p1 - p0) * t);
  if (!share) return std::nullopt;
  return PathHit{t, d0 > 0 ? 1.0 : -1.0, *share};
}

std::optional<PathHit> path_hit_outside(Vec3 p0, Vec3 p1, const Corners& triangle) {
  const Vec3 n = area_normal(triangle);
  const double d0 = dot(n, p0 - triangle[0]), d1 = dot(n, p1 - triangle[0]);
  if (d0 < 0 || d1 >= 0) return std::nullopt;
  const double t = d0 / (d0 - d1);
  const auto share = inside(triangle, p0 + (p1 - p0) * t);
  if (!share) return std::nullopt;
  return PathHit{t, 1, *share};
}

}  // namespace toile::paper
