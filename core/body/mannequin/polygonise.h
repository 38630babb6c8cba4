#pragma once

#include "core/body/mannequin/field_sample.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::mannequin {

struct GridBox {
  Vec3 low, high;
  double cell = 0.01;
};

/// The zero surface of `surface` inside the box as a closed manifold with outward triangles, by marching
/// cubes (W. Lorensen and H. Cline, 1987) whose loops are followed face by face, so that neighbours always
/// agree. The surface must not touch the box. Only blocks of cells that lie near the surface are looked at,
/// so `value` must be close to the distance there.
geometry::TriangleMesh polygonise(const ImplicitSurface& surface, const GridBox& box);

}  // namespace toile::mannequin
