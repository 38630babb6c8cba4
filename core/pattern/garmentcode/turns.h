#pragma once
// Rotations as the file counts them and as a project does. Internal to garmentcode.

#include <array>

#include "core/base/types.h"

namespace toile::garmentcode {

/// Degrees about the fixed axes x, then y, then z, which a project counts in, of a turn about x, then the
/// turned y, then the turned z, which the file counts in.
Vec3 fixed_angles(const std::array<double, 3>& own);

}  // namespace toile::garmentcode
