#pragma once

#include <vector>

#include "core/base/types.h"

namespace toile::geometry {

/// The corners of the convex hull of points, counter-clockwise; a single point or none where that is all
/// there is. Two chains over the sorted points, after Andrew, "Another efficient algorithm for convex hulls
/// in two dimensions" (1979).
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// The length around a closed polygon.
double perimeter(const std::vector<Vec2>& polygon);

/// The perimeter of the convex hull of points; 0 for fewer than two.
double hull_perimeter(std::vector<Vec2> points);

}  // namespace toile::geometry
