#pragma once
// Keeps cloth from passing through limbs whole: a triangle that spans a limb drawn in thin has its corners on
// both sides of it, and each of them is pushed out where it is.

#include <array>
#include <span>
#include <vector>

#include "core/dressing/linking.h"
#include "core/dressing/staging.h"
#include "core/sewing/garment_mesh.h"

namespace toile::dressing {

/// A straight piece of a limb's middle line within the body, m.
using Axis = std::array<Vec3, 2>;

std::vector<Axis> axes_of(const Skeleton& skeleton);

/// What is to be kept whole between edges that seams are to join: a limb that came out there would stay
/// outside.
struct Gaps {
  std::vector<Axis> axes;
  std::vector<Tri> triangles;  ///< from one edge to the other
};

/// The gaps in what is for arms and legs, which alone are kept in: over a shoulder the straight way from
/// front to back leads through the body at first.
Gaps gaps_of(const sewing::GarmentMesh& garment, std::span<const Covers> covers, const Skeleton& skeleton);

class AxisGuard {
 public:
  /// `triangles` must outlive it. What an axis goes through at `x` may go on so.
  AxisGuard(std::vector<Axis> axes, std::span<const Tri> triangles, std::span<const Vec3> x, Gaps gaps = {});

  /// Takes corners of triangles that an axis would newly go through back to where they were `before`.
  void keep(std::span<const Vec3> before, std::vector<Vec3>& x);

 private:
  /// Cloth first, then gaps.
  const Tri& triangle(std::size_t t) const {
    return t < triangles_.size() ? triangles_[t] : gaps_.triangles[t - triangles_.size()];
  }
  bool is_crossed(std::size_t t, std::span<const Vec3> x) const;

  std::vector<Axis> axes_;
  std::span<const Tri> triangles_;
  Gaps gaps_;
  std::vector<bool> crossed_;  ///< one a triangle
};

}  // namespace toile::dressing
