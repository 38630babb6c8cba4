#pragma once
// Closest points of two features, with the points themselves.

#include <span>

#include "core/base/types.h"
#include "core/geometry/distance.h"

namespace toile::collision {

struct OnTriangle {
  geometry::TrianglePoint at;
  Vec3 q;
};
/// On a triangle of the surface at `x`, to p.
inline OnTriangle nearest_on(Vec3 p, std::span<const Vec3> x, const Tri& t) {
  const geometry::TrianglePoint at = geometry::closest_on_triangle(p, x[t[0]], x[t[1]], x[t[2]]);
  return {at, x[t[0]] * at.a + x[t[1]] * at.b + x[t[2]] * at.c};
}

struct BetweenEdges {
  geometry::EdgePoints at;
  Vec3 p, q;
};
inline BetweenEdges nearest_between(Vec3 p0, Vec3 p1, Vec3 q0, Vec3 q1) {
  const geometry::EdgePoints at = geometry::closest_on_edges(p0, p1, q0, q1);
  return {at, p0 + (p1 - p0) * at.s, q0 + (q1 - q0) * at.t};
}

}  // namespace toile::collision
