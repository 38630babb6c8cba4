#pragma once
// Which limbs a closed line goes around, by linking numbers: no shape or place of the line matters, only how
// it and the body are looped.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/body/measure/figure.h"

namespace toile::dressing {

/// How often two closed lines wind around each other (Gauss 1833), each from its last point back to its
/// first. The sum over pairs of straight pieces after Klenin and Langowski, "Computation of writhe in
/// modeling of supercoiled DNA" (2000), equation 16. REQUIRES lines that do not touch.
int linking_number(std::span<const Vec3> a, std::span<const Vec3> b);

/// A part of Gauss's integral: a closed line and an open one. Sums over open lines that join into a closed
/// one give the linking number.
double gauss_integral(std::span<const Vec3> closed, std::span<const Vec3> open);

enum Limb { kHead, kLeftArm, kRightArm, kLeftLeg, kRightLeg, kLimbCount };

/// The middle lines of a standing body, each from the trunk's middle out along a limb and on to far away.
using Skeleton = std::array<std::vector<Vec3>, kLimbCount>;
Skeleton skeleton_of(const measure::BodyFigure& figure);

/// How often a ring goes around each limb, counted in one direction and up to a common number: the least that
/// goes with the ring. All 0: around nothing.
struct Enclosure {
  std::array<int, kLimbCount> times{};
  bool nothing() const { return *this == Enclosure{}; }
  /// Around each limb once or not at all.
  bool simple() const;
  friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// Nothing where the ring touches the skeleton.
std::optional<Enclosure> enclosed_by(std::span<const Vec3> ring, const Skeleton& skeleton);

}  // namespace toile::dressing
