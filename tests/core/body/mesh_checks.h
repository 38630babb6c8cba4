#pragma once
// What a proper body mesh must be, for the tests of this room.

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/geometry/triangle_mesh.h"

namespace toile {

/// Edges that are not run through exactly once in each direction: 0 for a closed manifold.
inline int open_edges(const geometry::TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, int> count;
  for (const Tri& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) ++count[{t[c], t[(c + 1) % 3]}];
  int open = 0;
  for (const auto& [edge, n] : count) open += n != 1 || !count.contains({edge.second, edge.first});
  return open;
}

/// Whether the triangles around every vertex make one fan.
inline bool fans_are_whole(const geometry::TriangleMesh& mesh) {
  std::vector<std::map<Index, Index>> next(mesh.vertices.size());
  for (const Tri& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) next[t[c]][t[(c + 1) % 3]] = t[(c + 2) % 3];
  for (const auto& ring : next) {
    if (ring.empty()) return false;
    size_t steps = 0;
    for (Index v = ring.begin()->first; steps < ring.size() + 1 && ring.contains(v);) {
      v = ring.at(v);
      ++steps;
      if (v == ring.begin()->first) break;
    }
    if (steps != ring.size()) return false;
  }
  return true;
}

inline double volume(const geometry::TriangleMesh& mesh) {
  double sum = 0;
  for (const Tri& t : mesh.triangles) {
    sum += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
  }
  return sum;
}

inline bool segment_hits(Vec3 p, Vec3 q, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 n = cross(b - a, c - a);
  const double dp = dot(n, p - a), dq = dot(n, q - a);
  if (!((dp < 0 && dq > 0) || (dp > 0 && dq < 0))) return false;
  const Vec3 x = p + (q - p) * (dp / (dp - dq));
  return dot(cross(b - a, x - a), n) > 0 && dot(cross(c - b, x - b), n) > 0 &&
         dot(cross(a - c, x - c), n) > 0;
}

/// Pairs of triangles without a common vertex of which one's edge passes through the other.
inline int self_crossings(const geometry::TriangleMesh& mesh) {
  std::vector<Index> order(mesh.triangles.size());
  const auto corner = [&](Index t, int c) { return mesh.vertices[mesh.triangles[t][c]]; };
  const auto low = [&](Index t) { return std::min({corner(t, 0).x, corner(t, 1).x, corner(t, 2).x}); };
  const auto high = [&](Index t) { return std::max({corner(t, 0).x, corner(t, 1).x, corner(t, 2).x}); };
  for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return low(a) < low(b); });
  int crossings = 0;
  for (size_t i = 0; i < order.size(); ++i) {
    for (size_t j = i + 1; j < order.size() && low(order[j]) <= high(order[i]); ++j) {
      const Tri &s = mesh.triangles[order[i]], &t = mesh.triangles[order[j]];
      const bool touch =
          std::any_of(s.begin(), s.end(), [&](Index v) { return v == t[0] || v == t[1] || v == t[2]; });
      if (touch) continue;
      for (int c = 0; c < 3; ++c) {
        const Index a = order[i], b = order[j];
        crossings +=
            segment_hits(corner(a, c), corner(a, (c + 1) % 3), corner(b, 0), corner(b, 1), corner(b, 2));
        crossings +=
            segment_hits(corner(b, c), corner(b, (c + 1) % 3), corner(a, 0), corner(a, 1), corner(a, 2));
      }
    }
  }
  return crossings;
}

/// The smallest angle of any triangle, radians.
inline double least_angle(const geometry::TriangleMesh& mesh) {
  double least = 10;
  for (const Tri& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 a = mesh.vertices[t[c]], u = normalized(mesh.vertices[t[(c + 1) % 3]] - a),
                 v = normalized(mesh.vertices[t[(c + 2) % 3]] - a);
      least = std::min(least, std::acos(std::clamp(dot(u, v), -1.0, 1.0)));
    }
  }
  return least;
}

}  // namespace toile
