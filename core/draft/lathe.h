#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::draft {

/// A closed solid of revolution about the y axis. `profile` (radius, height), m, runs from the axis below to
/// the axis above, outside on its right. `around` triangles' edges make a circle.
geometry::TriangleMesh turned_solid(const std::vector<Vec2>& profile, int around);

/// A box between two corners, m, closed, its faces cut into squares of about `step`.
geometry::TriangleMesh box_solid(Vec3 low, Vec3 high, double step);

}  // namespace toile::draft
