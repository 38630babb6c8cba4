#pragma once
// Where a drawn outline has corners, and where it is a curve in samples.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/outline.h"

namespace toile::pattern {

inline constexpr double kCornerWindow = 1.5;  ///< mm, over which directions at a corner are measured

/// Indices of the corners of a closed polyline that turn by more than the angle (radians), ascending.
/// REQUIRES neighbours apart, at least 3 vertices.
std::vector<std::size_t> find_corners(std::span<const Vec2> loop, double corner_angle);

/// The corners that are blunter than settings.corner_angle, as OutlineSettings::blunt_corner_angle says.
/// REQUIRES what find_corners() does.
std::vector<Vec2> blunt_corners(std::span<const Vec2> loop, const OutlineSettings& settings);

}  // namespace toile::pattern
