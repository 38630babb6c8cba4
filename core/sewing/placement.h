#pragma once
// Where a flat panel stands in space before it is sewn.

#include <variant>
#include <vector>

#include "core/base/types.h"

namespace toile::sewing {

/// The panel as a rigid sheet. A flat point (u, v) in metres goes to translation + R·(u, v, 0), with R the
/// rotation about x, then y, then z (fixed axes). The right side of the cloth faces R·(0, 0, 1).
struct RigidPlacement {
  Vec3 translation;      ///< m, where the panel's flat origin goes
  Vec3 rotation;         ///< radians about x, y, z
  bool flipped = false;  ///< mirror u first: the panel seen from its wrong side
};

/// The panel rolled, without stretching, around an axis, upright unless told otherwise. The flat point
/// `anchor` comes to `angle` at `height`; u runs along the circle (towards larger angles, counter-clockwise
/// seen from above), v along the axis, after `turn`. With `slope` the surface is a cone: its radius grows by
/// `slope` metres for every metre downwards along v. The right side faces away from the axis.
struct WrappedPlacement {
  Vec3 axis;             ///< m, a point on the axis, from which heights count
  double radius = 0.3;   ///< m, at the anchor
  double angle = 0;      ///< radians; 0 is +z (front), π/2 is +x; about a tilted axis: what comes nearest
  double height = 1;     ///< m along the axis, of the anchor
  Vec2 anchor;           ///< m, flat
  double slope = 0;      ///< radius change per metre of cloth downwards, in (-1, 1)
  Vec3 up{0, 1, 0};      ///< along the axis; of one along z, angle 0 is +y
  double turn = 0;       ///< radians by which the flat piece is turned about the anchor first
  bool flipped = false;  ///< mirror u about the anchor after the turn: the right side faces the axis
};

using Placement = std::variant<RigidPlacement, WrappedPlacement>;

/// The 3D start of flat points `rest` (m).
std::vector<Vec3> place(const std::vector<Vec2>& rest, const Placement& placement);

}  // namespace toile::sewing
