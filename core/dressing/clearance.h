#pragma once
// The gaps of a certified start: contact needs some way between all surfaces before it can keep them apart.

#include <span>
#include <vector>

#include "core/collision/obstacle.h"

namespace toile::dressing {

/// m; gaps under this are opened, and a start with one is not certified. Several times what the exact count
/// of crossings and the division planes of contact round to.
inline constexpr double kLeastGap = 1e-4;

/// m, the least distance of cloth to itself and to obstacles, as contact measures it (features of one vertex
/// are no pair); 1 where nothing is near.
double least_gap(const collision::Surface& cloth, std::span<const collision::Obstacle> obstacles,
                 std::span<const Vec3> x);

/// Moves what is nearer than twice kLeastGap apart, along its contacts. Gives back the least gap that is
/// left.
double open_gaps(const collision::Surface& cloth, std::span<const collision::Obstacle> obstacles,
                 std::vector<Vec3>& x);

}  // namespace toile::dressing
