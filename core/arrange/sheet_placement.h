#pragma once
// From places on a sheet to placements in space.

#include <array>

#include "core/arrange/flat_move.h"
#include "core/sewing/placement.h"

namespace toile::arrange {

/// Angles (radians) about the fixed axes x, then y, then z of the turn whose columns are given; z stays
/// unturned where x and z turn alike. REQUIRES unit vectors at right angles, right-handed.
Vec3 turn_angles(const std::array<Vec3, 3>& column);

/// A sheet before (face 1) or behind (-1) the body at depth `z` (m). The pose is mirrored where the piece's
/// upper side looks to -z.
sewing::RigidPlacement on_upright_sheet(const FlatMove& pose, double z);

/// A sheet beside the body at `x` (m): the pose leads to (z, y). It is mirrored where the piece's upper side
/// looks to +x.
sewing::RigidPlacement on_side_sheet(const FlatMove& pose, double x);

}  // namespace toile::arrange
