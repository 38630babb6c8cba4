#pragma once

#include "core/body/mannequin/field_sample.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::mannequin {

struct RemeshSettings {
  Index triangle_count = 3300;
  std::function<double(Vec3)> fineness;  ///< edge length wanted at a point, relative; empty: 1 everywhere
  int rounds = 8;
};

/// The point of the surface that Newton steps along the gradient lead to, no farther than `reach` from p.
SurfacePoint project(const ImplicitSurface& surface, Vec3 p, double reach);

/// Even triangles on the surface, as many as asked (met exactly, or off by one when the count is odd), by
/// isotropic remeshing: split, collapse, flip, tangential relaxation, projection (M. Botsch and L. Kobbelt,
/// "A remeshing approach to multiresolution modeling", 2004). `mesh` is a closed manifold near the surface.
geometry::TriangleMesh remesh(geometry::TriangleMesh mesh, const ImplicitSurface& surface,
                              const RemeshSettings& settings);

/// Moves a mesh onto a surface that lies close to it, keeping its triangles, and evens it out `relaxations`
/// times.
geometry::TriangleMesh refit(geometry::TriangleMesh mesh, const ImplicitSurface& surface,
                             const RemeshSettings& settings, int relaxations);

}  // namespace toile::mannequin
