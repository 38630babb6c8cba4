#pragma once
// Who is next to whom on a triangle mesh, as flat arrays. Works on any indexed triangle list: a panel, a
// garment, a body.

#include <array>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace toile::mesh {

/// An edge of a triangle mesh. It runs v0 → v1 in the winding of t0, and v1 → v0 in that of t1, so that on
/// a border (t1 == kNone) the surface lies to its left.
struct MeshEdge {
  Index v0 = kNone, v1 = kNone;
  Index t0 = kNone, t1 = kNone;                ///< t0 < t1; t1 is kNone on the border
  Index opposite0 = kNone, opposite1 = kNone;  ///< the corner of t0, and of t1, that is not on the edge
  friend bool operator==(const MeshEdge&, const MeshEdge&) = default;
};

/// Every edge once, ordered by its lesser vertex, then its greater one. `triangles` index 0 … vertex_count-1
/// (checked: out of range aborts). Where check_manifold fails, a triangle that finds no free partner of
/// opposite winding stands as a border edge of its own, so that an edge may be listed more than once.
std::vector<MeshEdge> edges_of(std::span<const Tri> triangles, Index vertex_count);

/// Fails where an edge has more than two triangles, where two neighbours wind against each other, where a
/// triangle names a vertex twice or one outside 0 … vertex_count-1. Codes: "mesh.non_manifold",
/// "mesh.winding", "mesh.degenerate_triangle", "mesh.index"; `where` names the triangle.
Status check_manifold(std::span<const Tri> triangles, Index vertex_count);

/// For each triangle the neighbour across the edge opposite its corner i, kNone on the border.
std::vector<std::array<Index, 3>> neighbours_of(std::span<const Tri> triangles,
                                                std::span<const MeshEdge> edges);

/// Closed border lines: loop i is vertices[first[i]] … vertices[first[i + 1] - 1], surface to the left.
struct BoundaryLoops {
  std::vector<Index> vertices;
  std::vector<Index> first{0};  ///< one entry per loop, and one past the last
  Index count() const { return static_cast<Index>(first.size()) - 1; }
};

/// The border edges joined up, each loop from its least vertex on, loops in order of that vertex. Where
/// loops touch in a vertex they are parted there, turning towards the lower next vertex first.
BoundaryLoops boundary_loops(std::span<const MeshEdge> edges);

/// Vertices - edges + triangles of a manifold mesh whose vertices are all used: 1 for a disk, 2 - 2·genus
/// - borders in general.
Index euler_characteristic(std::span<const Tri> triangles, Index vertex_count);

}  // namespace toile::mesh
