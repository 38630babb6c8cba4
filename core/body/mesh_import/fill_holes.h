#pragma once

#include <vector>

#include "core/body/mesh_import/half_edges.h"

namespace toile::mesh_import {

struct FilledHoles {
  int filled = 0;     ///< holes
  int triangles = 0;  ///< that fill them
  int left = 0;       ///< borders that stay
};

/// Fills small holes: a border whose length is at most `most` times the diagonal of the box around its shell,
/// so that a neck or a wrist that was cut open is shut, and a bowl or a sheet stays what it is. New triangles
/// come last and run like their neighbours; a hole of many corners gets a vertex in its middle. REQUIRES fans
/// that have been split (split_fans) and triangles turned alike within `shells`; one-sided shells are left
/// alone.
FilledHoles fill_holes(geometry::TriangleMesh& mesh, const HalfEdges& edges, const MeshShells& shells,
                       double most);

}  // namespace toile::mesh_import
