#pragma once
// Makes a triangulation homogeneous: moves its inner vertices, and says where vertices are missing or too
// many.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/grid_triangulation.h"

namespace toile::mesh {

/// Wanted edge length at each of `points`, in grid units: `spacing`, but near a border that is divided
/// finer as fine as there, growing by kGrading per unit of way. The first `border` points are border points
/// (and those of lines through the piece), whose own edges are `segments`.
std::vector<double> wanted_lengths(std::span<const GridPoint> points, std::span<const Tri> triangles,
                                   std::span<const std::array<Index, 2>> segments, Index border,
                                   double spacing);

/// Moves each vertex from `border` on, in order, towards the mean of the triangles around it, weighted so
/// that triangles become equal in measure of the wanted length; then restores the Delaunay property.
void smooth(GridTriangulation& mesh, Index border, Index count, std::span<const double> wanted);

/// The inner points from `border` on, with points added on edges that are too long and points taken from
/// edges that are too short; nothing when all edges do.
std::optional<std::vector<GridPoint>> adapted_points(std::span<const GridPoint> points,
                                                     std::span<const Tri> triangles,
                                                     std::span<const std::array<Index, 2>> segments,
                                                     Index border, std::span<const double> wanted);

}  // namespace toile::mesh
