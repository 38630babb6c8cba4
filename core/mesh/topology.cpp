#include "core/mesh/topology.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "core/base/check.h"

namespace toile::mesh {
namespace {

struct HalfEdge {
  Index low, high;  ///< vertices, sorted
  Index triangle;
  Index corner;  ///< of the triangle, opposite the edge
  bool rising;   ///< runs low → high in the triangle's winding
};

std::vector<HalfEdge> sorted_half_edges(std::span<const Tri> triangles) {
  std::vector<HalfEdge> half_edges;
  half_edges.reserve(triangles.size() * 3);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Index a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
      half_edges.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(t), i, a < b});
    }
  }
  std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
    return std::tie(x.low, x.high, x.triangle, x.corner) < std::tie(y.low, y.high, y.triangle, y.corner);
  });
  return half_edges;
}

MeshEdge border_edge(const HalfEdge& h, std::span<const Tri> triangles) {
  MeshEdge edge;
  edge.v0 = h.rising ? h.low : h.high;
  edge.v1 = h.rising ? h.high : h.low;
  edge.t0 = h.triangle;
  edge.opposite0 = triangles[h.triangle][h.corner];
  return edge;
}

/// Adds the half-edges of one pair of vertices: each joins the first open edge of opposite winding.
void append_group(std::span<const HalfEdge> group, std::span<const Tri> triangles,
                  std::vector<MeshEdge>& edges) {
  const std::size_t begin = edges.size();
  for (const HalfEdge& h : group) {
    const Index from = h.rising ? h.low : h.high;
    const auto open = std::find_if(edges.begin() + begin, edges.end(),
                                   [&](const MeshEdge& e) { return e.t1 == kNone && e.v0 != from; });
    if (open == edges.end()) {
      edges.push_back(border_edge(h, triangles));
    } else {
      open->t1 = h.triangle;
      open->opposite1 = triangles[h.triangle][h.corner];
    }
  }
}

/// End of the run of half-edges that share begin's two vertices.
std::size_t group_end(const std::vector<HalfEdge>& half_edges, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < half_edges.size() && half_edges[end].low == half_edges[begin].low &&
         half_edges[end].high == half_edges[begin].high) {
    ++end;
  }
  return end;
}

std::string triangle_name(std::size_t t) { return "triangle " + std::to_string(t); }

Status check_indices(std::span<const Tri> triangles, Index vertex_count) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Tri& v = triangles[t];
    for (const Index i : v) {
      if (i < 0 || i >= vertex_count) {
        return Error{"mesh.index", "A triangle names vertex " + std::to_string(i) + ", which does not exist.",
                     triangle_name(t)};
      }
    }
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
      return Error{"mesh.degenerate_triangle", "A triangle names the same vertex twice.", triangle_name(t)};
    }
  }
  return {};
}

}  // namespace

std::vector<MeshEdge> edges_of(std::span<const Tri> triangles, Index vertex_count) {
  for (const Tri& t : triangles) {
    for (const Index v : t) TOILE_CHECK(v >= 0 && v < vertex_count);
  }
  const std::vector<HalfEdge> half_edges = sorted_half_edges(triangles);
  std::vector<MeshEdge> edges;
  edges.reserve(half_edges.size() / 2 + 16);
  for (std::size_t begin = 0; begin < half_edges.size();) {
    const std::size_t end = group_end(half_edges, begin);
    append_group(std::span(half_edges).subspan(begin, end - begin), triangles, edges);
    begin = end;
  }
  return edges;
}

Status check_manifold(std::span<const Tri> triangles, Index vertex_count) {
  TRY(check_indices(triangles, vertex_count));
  const std::vector<HalfEdge> half_edges = sorted_half_edges(triangles);
  for (std::size_t begin = 0; begin < half_edges.size();) {
    const std::size_t end = group_end(half_edges, begin);
    const HalfEdge& h = half_edges[begin];
    const std::string edge = "edge " + std::to_string(h.low) + "-" + std::to_string(h.high);
    const std::string where = triangle_name(half_edges[end - 1].triangle);
    if (end - begin > 2) {
      return Error{"mesh.non_manifold", "More than two triangles meet in " + edge + ".", where};
    }
    if (end - begin == 2 && h.rising == half_edges[begin + 1].rising) {
      return Error{"mesh.winding", "The two triangles at " + edge + " wind against each other.", where};
    }
    begin = end;
  }
  return {};
}

std::vector<std::array<Index, 3>> neighbours_of(std::span<const Tri> triangles,
                                                std::span<const MeshEdge> edges) {
  std::vector<std::array<Index, 3>> neighbours(triangles.size(), {kNone, kNone, kNone});
  const auto set = [&](Index t, Index opposite, Index other) {
    for (int i = 0; i < 3; ++i) {
      if (triangles[t][i] == opposite) neighbours[t][i] = other;
    }
  };
  for (const MeshEdge& e : edges) {
    if (e.t1 == kNone) continue;
    set(e.t0, e.opposite0, e.t1);
    set(e.t1, e.opposite1, e.t0);
  }
  return neighbours;
}

BoundaryLoops boundary_loops(std::span<const MeshEdge> edges) {
  std::vector<std::array<Index, 2>> next;  // from, to; sorted
  for (const MeshEdge& e : edges) {
    if (e.t1 == kNone) next.push_back({e.v0, e.v1});
  }
  std::sort(next.begin(), next.end());
  std::vector<bool> used(next.size(), false);
  BoundaryLoops loops;
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (used[start]) continue;
    for (std::size_t i = start; i < next.size() && !used[i];) {
      used[i] = true;
      loops.vertices.push_back(next[i][0]);
      const Index to = next[i][1];
      if (to == next[start][0]) break;
      i = std::lower_bound(next.begin(), next.end(), std::array<Index, 2>{to, kNone}) - next.begin();
      while (i < next.size() && next[i][0] == to && used[i]) ++i;
      if (i < next.size() && next[i][0] != to) break;  // only on a mesh that check_manifold refuses
    }
    loops.first.push_back(static_cast<Index>(loops.vertices.size()));
  }
  return loops;
}

Index euler_characteristic(std::span<const Tri> triangles, Index vertex_count) {
  const auto edge_count = static_cast<Index>(edges_of(triangles, vertex_count).size());
  return vertex_count - edge_count + static_cast<Index>(triangles.size());
}

}  // namespace toile::mesh
