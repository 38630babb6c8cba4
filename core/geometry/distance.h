#pragma once
// Closest points of points, edges and triangles. After Ericson, "Real-Time Collision Detection" (2005),
// sections 5.1.5 and 5.1.9. Pure functions in double: gaps of micrometres need it. Inline: contact asks
// for millions of them.

#include <algorithm>

#include "core/base/types.h"

namespace toile::geometry {

/// The closest point of a triangle, as weights of its corners (sum 1, none negative).
struct TrianglePoint {
  double a = 1, b = 0, c = 0;
};

inline TrianglePoint closest_on_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double t = d1 / (d1 - d3);
    return {1 - t, t, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double t = d2 / (d2 - d6);
    return {1 - t, 0, t};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - t, t};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0)) return {1, 0, 0};  // a triangle without area
  return {va / sum, vb / sum, vc / sum};
}

/// Closest points of two edges: p0 + s·(p1 − p0) and q0 + t·(q1 − q0), with s and t in [0, 1].
struct EdgePoints {
  double s = 0, t = 0;
};

inline EdgePoints closest_on_edges(Vec3 p0, Vec3 p1, Vec3 q0, Vec3 q1) {
  const Vec3 u = p1 - p0, v = q1 - q0, r = p0 - q0;
  const double a = dot(u, u), e = dot(v, v), f = dot(v, r);
  if (a <= 0 && e <= 0) return {0, 0};
  if (a <= 0) return {0, std::clamp(f / e, 0.0, 1.0)};
  const double c = dot(u, r);
  if (e <= 0) return {std::clamp(-c / a, 0.0, 1.0), 0};
  const double b = dot(u, v), denominator = a * e - b * b;
  // Parallel edges: any s serves; the middle keeps the pair's normal steady.
  double s = denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.5;
  double t = (b * s + f) / e;
  if (t < 0) {
    t = 0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1) {
    t = 1;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return {s, t};
}

}  // namespace toile::geometry
