#pragma once
// A triangle mesh of any quality as half-edges: which sides of its triangles belong together, also where more
// than two triangles meet at an edge.

#include <vector>

#include "core/geometry/triangle_mesh.h"

namespace toile::mesh_import {

/// Half-edge 3·t + c runs from corner c to corner c + 1 of triangle t.
constexpr Index triangle_of(Index half_edge) { return half_edge / 3; }
constexpr Index next_in_triangle(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline Index start_of(const geometry::TriangleMesh& mesh, Index h) { return mesh.triangles[h / 3][h % 3]; }
inline Index end_of(const geometry::TriangleMesh& mesh, Index h) {
  return start_of(mesh, next_in_triangle(h));
}

struct HalfEdges {
  std::vector<Index> mate;  ///< of each half-edge the one across its edge, kNone at a border
  int crowded = 0;          ///< edges at which more than two triangles meet
};

/// Pairs the half-edges. At a crowded edge those two belong together that bound solid between them, as far as
/// the triangles' sides tell: first among patches that have no border, as an outer wall has none and a fin
/// has; of what is then left, the last two. Neighbours may run the same way: sides are not looked at where
/// only two meet. REQUIRES three different corners to each triangle.
HalfEdges pair_half_edges(const geometry::TriangleMesh& mesh);

/// Triangles that hang together, and which of them are turned against the others.
struct MeshShells {
  std::vector<Index> shell_of;  ///< of each triangle; numbered by first triangle
  std::vector<bool> turned;     ///< of each triangle: against the majority of its shell
  std::vector<bool> one_sided;  ///< of each shell: cannot be turned alike, as a Möbius strip
  Index count = 0;
};
MeshShells find_shells(const geometry::TriangleMesh& mesh, const HalfEdges& edges);

/// Gives every fan of triangles around a vertex a vertex of its own, so that surfaces that only touch there
/// are apart; the first fan keeps the vertex, others get new ones at the end. Fans of one shell that end at
/// borders stay together: between them lie holes. Returns how many vertices are new.
int split_fans(geometry::TriangleMesh& mesh, const HalfEdges& edges, const MeshShells& shells);

}  // namespace toile::mesh_import
