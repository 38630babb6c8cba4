#pragma once
// Closest points of points, edges and triangles. After Ericson, "Real-Time Collision Detection" (2005),
// sections 5.1.5 and 5.1.9. Pure functions in double: gaps of micrometres need it.

#include "core/base/types.h"

namespace toile {

/// The closest point of a triangle, as weights of its corners (sum 1, none negative).
struct TrianglePoint {
  double a = 1, b = 0, c = 0;
};
TrianglePoint closest_on_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c);

/// Closest points of two edges: p0 + s·(p1 − p0) and q0 + t·(q1 − q0), with s and t in [0, 1].
struct EdgePoints {
  double s = 0, t = 0;
};
EdgePoints closest_on_edges(Vec3 p0, Vec3 p1, Vec3 q0, Vec3 q1);

}  // namespace toile
