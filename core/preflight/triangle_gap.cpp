#include "core/preflight/triangle_gap.h"

#include <algorithm>

#include "core/collision/crossings.h"
#include "core/geometry/distance.h"

namespace toile::preflight {

namespace {

bool is_corner(const GapTriangle& t, Index type) {
  return t.type[0] == type || t.type[1] == type || t.type[2] == type;
}

double corner_gap(const GapTriangle& a, const GapTriangle& b) {
  double least = 1;
  for (int k = 0; k < 3; ++k) {
    if (is_corner(b, a.type[k])) continue;
    const geometry::TrianglePoint w = geometry::closest_on_triangle(a.x[k], b.x[0], b.x[1], b.x[2]);
    least = std::min(least, length(a.x[k] - (b.x[0] * w.a + b.x[1] * w.b + b.x[2] * w.c)));
  }
  return least;
}

double edge_gap(const GapTriangle& a, const GapTriangle& b) {
  double least = 1;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3;
      if (a.type[i] == b.type[j] || a.type[i] == b.type[j1] || a.type[i1] == b.type[j] ||
          a.type[i1] == b.type[j1])
        continue;
      const geometry::EdgePoints e = geometry::closest_on_edges(a.x[i], a.x[i1], b.x[j], b.x[j1]);
      const Vec3 p = a.x[i] + (a.x[i1] - a.x[i]) * e.s, q = b.x[j] + (b.x[j1] - b.x[j]) * e.t;
      least = std::min(least, length(p - q));
    }
  }
  return least;
}

bool edge_crosses(const GapTriangle& a, int k, const GapTriangle& b) {
  return collision::segment_crosses_triangle(collision::to_grid(a.x[k]), collision::to_grid(a.x[(k + 1) % 3]),
                                             collision::to_grid(b.x[0]), collision::to_grid(b.x[1]),
                                             collision::to_grid(b.x[2]));
}

}  // namespace

double triangle_gap(const GapTriangle& a, const GapTriangle& b) {
  if (triangles_cross(a, b)) return 0;
  return std::min({corner_gap(a, b), corner_gap(b, a), edge_gap(a, b)});
}

bool triangles_cross(const GapTriangle& a, const GapTriangle& b) {
  int shared = 0, corner_a = 0, corner_b = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a.type[i] == b.type[j]) {
        ++shared;
        corner_a = i;
        corner_b = j;
      }
    }
  }
  if (shared > 1) return false;
  // Beside a shared corner only the edges opposite to it can pass through.
  if (shared == 1) return edge_crosses(a, (corner_a + 1) % 3, b) || edge_crosses(b, (corner_b + 1) % 3, a);
  for (int k = 0; k < 3; ++k) {
    if (edge_crosses(a, k, b) || edge_crosses(b, k, a)) return true;
  }
  return false;
}

}  // namespace toile::preflight
