#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::mesh {

/// Unit normal of each vertex: its triangles' normals, weighted by their angle at the vertex (Thürmer and
/// Wüthrich 1998), so that the mesh's cut does not show. Vertices with one `weld` share their triangles,
/// which makes shading run smoothly across a seam; where the joint surface folds back on itself (a crease, or
/// pieces sewn right side to wrong side) a vertex keeps the normal of its own piece. A vertex without area
/// gets (0, 0, 1). `weld`: one entry per position (GarmentMesh::weld), or empty. REQUIRES all indices in
/// range.
std::vector<Vec3> vertex_normals(std::span<const Vec3> positions, std::span<const Tri> triangles,
                                 std::span<const Index> weld = {});

}  // namespace toile::mesh
