#pragma once
// How a garment's surface is curved, as a tensor in space.

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/sewing/garment_mesh.h"

namespace toile::analysis {

/// A symmetric 3×3 tensor.
struct SymmetricTensor {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  /// Adds s·(a⊗b + b⊗a)/2.
  void add(double s, Vec3 a, Vec3 b);
  void add(double s, const SymmetricTensor& other);
  double trace() const { return xx + yy + zz; }
  /// a·T·a.
  double along(Vec3 a) const;
};

/// The sum of products of all nine components, T:S.
double contracted(const SymmetricTensor& a, const SymmetricTensor& b);

/// Of each vertex, 1/m: the normal curvature along a unit vector d in the surface is d·κ·d, positive where
/// the surface bends away from its right side, as the outside of a tube does. Sewn vertices have one. After
/// Cohen-Steiner and Morvan 2003, "Restricted Delaunay triangulations and normal cycle": each edge bears its
/// angle times its length across itself, per area, here of all triangles within two edges.
std::vector<SymmetricTensor> surface_curvature(const sewing::GarmentMesh& garment,
                                               std::span<const Vec3> positions);

/// Of values of triangles, the mean at each vertex over all triangles within two edges, weighted by `weights`
/// (areas); sewn vertices have one.
std::vector<SymmetricTensor> spread(const sewing::GarmentMesh& garment,
                                    std::span<const SymmetricTensor> of_triangle,
                                    std::span<const double> weights);

/// m², as the triangles lie in space.
std::vector<double> triangle_areas(const sewing::GarmentMesh& garment, std::span<const Vec3> positions);

}  // namespace toile::analysis
