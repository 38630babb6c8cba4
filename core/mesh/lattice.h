#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::mesh {

/// A closed polygon without its first point repeated.
using Polygon = std::vector<Vec2>;

/// Points of a hexagonal lattice of edge length `spacing` inside `loops` (even-odd), at least `margin` away
/// from them. Rows run along x; the lattice starts at the least corner of the bounding box and is stretched
/// a little so that whole rows and columns fit it. They keep the margin from the open polylines `lines` too.
/// Any unit; row by row, each by increasing x.
std::vector<Vec2> lattice_points(std::span<const Polygon> loops, double spacing, double margin,
                                 std::span<const std::vector<Vec2>> lines = {});

}  // namespace toile::mesh
