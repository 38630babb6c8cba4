#pragma once
// Keeps cloth from passing through limbs whole: a triangle that spans a limb drawn in thin has its corners on
// both sides of it, and each of them is pushed out where it is.

#include <array>
#include <span>
#include <vector>

#include "core/dressing/linking.h"
#include "core/sewing/garment_mesh.h"

namespace toile::dressing {

/// The middle lines of the body's limbs, as straight pieces within it, m.
std::vector<std::array<Vec3, 2>> axes_of(const Skeleton& skeleton);

/// Triangles that close the gaps between the edges that seams join: sewn, none of them has an area. A limb that
/// came out through a gap would stay outside.
std::vector<Tri> across_seams(const sewing::GarmentMesh& garment);

class AxisGuard {
 public:
  /// `triangles` must outlive it. What an axis goes through at `x` may go on so.
  AxisGuard(std::vector<std::array<Vec3, 2>> axes, std::span<const Tri> triangles, std::span<const Vec3> x);

  /// Takes corners of triangles that an axis would newly go through back to where they were `before`.
  void keep(std::span<const Vec3> before, std::vector<Vec3>& x);

 private:
  bool is_crossed(std::size_t triangle, std::span<const Vec3> x) const;
  std::vector<bool> crossed_at(std::span<const Vec3> x) const;

  std::vector<std::array<Vec3, 2>> axes_;
  std::span<const Tri> triangles_;
  std::vector<bool> crossed_;  ///< one a triangle
};

}  // namespace toile::dressing
