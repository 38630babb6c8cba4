#include "core/body/mesh_import/half_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "core/base/disjoint_sets.h"

namespace toile::mesh_import {
namespace {

struct Side {
  Index low, high;  ///< vertices
  Index half_edge;
};

std::vector<Side> sorted_sides(const geometry::TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (Index h = 0; h < static_cast<Index>(3 * mesh.triangles.size()); ++h) {
    const auto [low, high] = std::minmax({start_of(mesh, h), end_of(mesh, h)});
    sides.push_back({low, high, h});
  }
  // Sides of one edge come together; by half-edge within, so that the pairing does not hang on the sort.
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (a.low != b.low) return a.low < b.low;
    return a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
  });
  return sides;
}

struct Leaf {
  double angle;  ///< about the edge
  bool along;    ///< runs from the lower to the higher vertex: its outer side looks towards greater angles
  Index half_edge;
};

/// The triangles about a crowded edge, as one goes around it.
std::vector<Leaf> leaves_around(const geometry::TriangleMesh& mesh, std::span<const Side> sides) {
  const Vec3 from = mesh.vertices[sides[0].low];
  const Vec3 axis = normalized(mesh.vertices[sides[0].high] - from);
  const auto across = [&](Index h) {
    const Vec3 way = mesh.vertices[end_of(mesh, next_in_triangle(h))] - from;
    return way - axis * dot(axis, way);
  };
  const Vec3 u = normalized(across(sides[0].half_edge)), v = cross(axis, u);
  std::vector<Leaf> leaves;
  for (const Side& side : sides) {
    const Vec3 way = across(side.half_edge);
    leaves.push_back(
        {std::atan2(dot(way, v), dot(way, u)), start_of(mesh, side.half_edge) == side.low, side.half_edge});
  }
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    return a.angle != b.angle ? a.angle < b.angle : a.half_edge < b.half_edge;
  });
  return leaves;
}

void join(std::vector<Index>& mate, Index a, Index b) {
  mate[a] = b;
  mate[b] = a;
}

/// Of each triangle, whether its patch ends at a border somewhere: what hangs together across edges at which
/// two triangles meet.
std::vector<bool> bordered(const geometry::TriangleMesh& mesh, std::span<const Side> sides,
                           std::span<const Index> mate) {
  DisjointSets patches(mesh.triangles.size());
  for (std::size_t h = 0; h < mate.size(); ++h) {
    if (mate[h] != kNone) patches.join(triangle_of(static_cast<Index>(h)), triangle_of(mate[h]));
  }
  std::vector<bool> by_root(mesh.triangles.size(), false), out(mesh.triangles.size(), false);
  const auto same = [&](std::size_t i, std::size_t j) {
    return sides[i].low == sides[j].low && sides[i].high == sides[j].high;
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool alone = (i == 0 || !same(i, i - 1)) && (i + 1 == sides.size() || !same(i, i + 1));
    if (alone) by_root[patches.root(triangle_of(sides[i].half_edge))] = true;
  }
  for (std::size_t t = 0; t < out.size(); ++t) out[t] = by_root[patches.root(static_cast<Index>(t))];
  return out;
}

/// Solid lies beyond a leaf that looks back, up to the next one, which then looks forward.
void pair_by_side(const std::vector<Leaf>& leaves, std::vector<Index>& mate) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const Leaf &a = leaves[i], &b = leaves[(i + 1) % leaves.size()];
    if (!a.along && b.along) join(mate, a.half_edge, b.half_edge);
  }
}

void pair_leaves(const std::vector<Leaf>& leaves, const std::vector<bool>& has_border,
                 std::vector<Index>& mate) {
  const auto left_over = [&](bool walls_only) {
    std::vector<Leaf> left;
    for (const Leaf& leaf : leaves) {
      if (walls_only && has_border[triangle_of(leaf.half_edge)]) continue;
      if (mate[leaf.half_edge] == kNone) left.push_back(leaf);
    }
    return left;
  };
  pair_by_side(left_over(true), mate);
  pair_by_side(left_over(false), mate);
  const std::vector<Leaf> last = left_over(false);
  if (last.size() == 2) join(mate, last[0].half_edge, last[1].half_edge);
}

/// Numbers the shell of triangle `first` and turns its triangles towards one another.
void fill_shell(const geometry::TriangleMesh& mesh, const HalfEdges& edges, Index first, MeshShells& out) {
  std::vector<Index> queue{first};
  out.shell_of[first] = out.count;
  std::size_t turned = 0;
  bool one_sided = false;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const Index t = queue[k];
    turned += out.turned[t];
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      const Index mate = edges.mate[h];
      if (mate == kNone) continue;
      const Index other = triangle_of(mate);
      const bool against = start_of(mesh, h) == start_of(mesh, mate);
      const bool turn = out.turned[t] != against;
      if (out.shell_of[other] == kNone) {
        out.shell_of[other] = out.count;
        out.turned[other] = turn;
        queue.push_back(other);
      } else {
        one_sided = one_sided || out.turned[other] != turn;
      }
    }
  }
  if (2 * turned > queue.size()) {
    for (const Index t : queue) out.turned[t] = !out.turned[t];
  }
  out.one_sided.push_back(one_sided);
  ++out.count;
}

/// Corners that go around a vertex together.
DisjointSets fans_of(const geometry::TriangleMesh& mesh, const HalfEdges& edges) {
  DisjointSets corners(edges.mate.size());
  for (Index h = 0; h < static_cast<Index>(edges.mate.size()); ++h) {
    const Index mate = edges.mate[h];
    if (mate < h) continue;  // none, or seen before
    const bool against = start_of(mesh, h) == start_of(mesh, mate);
    corners.join(h, against ? mate : next_in_triangle(mate));
    corners.join(next_in_triangle(h), against ? next_in_triangle(mate) : mate);
  }
  return corners;
}

/// By root, whether a fan ends at borders and does not go all the way round.
std::vector<bool> fans_with_ends(const HalfEdges& edges, DisjointSets& corners) {
  std::vector<bool> ends(edges.mate.size(), false);
  for (Index h = 0; h < static_cast<Index>(edges.mate.size()); ++h) {
    if (edges.mate[h] == kNone) ends[corners.root(h)] = ends[corners.root(next_in_triangle(h))] = true;
  }
  return ends;
}

}  // namespace

HalfEdges pair_half_edges(const geometry::TriangleMesh& mesh) {
  const std::vector<Side> sides = sorted_sides(mesh);
  HalfEdges out;
  out.mate.assign(sides.size(), kNone);
  std::vector<std::span<const Side>> crowded;
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high) {
      ++end;
    }
    if (end - first == 2) join(out.mate, sides[first].half_edge, sides[first + 1].half_edge);
    if (end - first > 2) crowded.push_back(std::span(sides).subspan(first, end - first));
  }
  out.crowded = static_cast<int>(crowded.size());
  if (crowded.empty()) return out;
  const std::vector<bool> has_border = bordered(mesh, sides, out.mate);
  for (const std::span<const Side> around : crowded) {
    pair_leaves(leaves_around(mesh, around), has_border, out.mate);
  }
  return out;
}

MeshShells find_shells(const geometry::TriangleMesh& mesh, const HalfEdges& edges) {
  MeshShells out;
  out.shell_of.assign(mesh.triangles.size(), kNone);
  out.turned.assign(mesh.triangles.size(), false);
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    if (out.shell_of[t] == kNone) fill_shell(mesh, edges, t, out);
  }
  return out;
}

int split_fans(geometry::TriangleMesh& mesh, const HalfEdges& edges, const MeshShells& shells) {
  DisjointSets corners = fans_of(mesh, edges);
  const std::vector<bool> ends = fans_with_ends(edges, corners);
  std::vector<bool> taken(mesh.vertices.size(), false);    // by its first fan
  std::vector<Index> vertex_of(edges.mate.size(), kNone);  // of each fan, by its root
  std::map<std::pair<Index, Index>, Index> of_ended;       // vertex and shell: their fans that end at borders
  const std::size_t before = mesh.vertices.size();
  for (Index h = 0; h < static_cast<Index>(edges.mate.size()); ++h) {
    Index& vertex = mesh.triangles[h / 3][h % 3];
    Index& own = vertex_of[corners.root(h)];
    if (own == kNone && ends[corners.root(h)]) {
      const auto found = of_ended.find({vertex, shells.shell_of[triangle_of(h)]});
      if (found != of_ended.end()) own = found->second;
    }
    if (own == kNone) {
      own = taken[vertex] ? static_cast<Index>(mesh.vertices.size()) : vertex;
      if (taken[vertex]) mesh.vertices.push_back(Vec3(mesh.vertices[vertex]));
      taken[vertex] = true;
      if (ends[corners.root(h)]) of_ended[{vertex, shells.shell_of[triangle_of(h)]}] = own;
    }
    vertex = own;
  }
  return static_cast<int>(mesh.vertices.size() - before);
}

}  // namespace toile::mesh_import
