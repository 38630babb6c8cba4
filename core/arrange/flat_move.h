#pragma once
// Isometries of the plane: where a flat piece lies when the garment is seen from the front.

#include <cmath>
#include <span>

#include "core/base/types.h"

namespace toile::arrange {

/// p ↦ R·p + t, with p.x negated first when `mirrored`; R turns by the angle whose cosine and sine are c, s.
struct FlatMove {
  double c = 1, s = 0;
  Vec2 t;
  bool mirrored = false;

  Vec2 turned(Vec2 p) const {
    if (mirrored) p.x = -p.x;
    return {c * p.x - s * p.y, s * p.x + c * p.y};
  }
  Vec2 operator()(Vec2 p) const { return turned(p) + t; }
  double angle() const { return std::atan2(s, c); }
};

/// First `inner`, then `outer`.
FlatMove after(const FlatMove& outer, const FlatMove& inner);

/// The move that brings points nearest to their targets (least squares), mirrored or not as told, and the
/// root of the mean square of what is left. REQUIRES spans of one length, at least one point.
struct FlatFit {
  FlatMove move;
  double rms = 0;
};
FlatFit fit_move(std::span<const Vec2> points, std::span<const Vec2> targets, bool mirrored);

/// REQUIRES at least one point.
Vec2 mean_of(std::span<const Vec2> points);

/// The mean of points and the unit vector along which they spread most (the major axis of their covariance).
struct PointAxes {
  Vec2 mean, along;
  bool spread = false;  ///< false: they are one point, and `along` says nothing
};
PointAxes axes_of(std::span<const Vec2> points);  ///< REQUIRES at least one point

/// A move that turns by `angle` (radians), without a shift.
FlatMove turn_by(double angle, bool mirrored);

}  // namespace toile::arrange
