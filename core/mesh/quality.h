#pragma once

#include <span>

#include "core/base/types.h"

namespace toile::mesh {

/// How even a flat triangle mesh is. Lengths and areas in the unit of the points; angles in radians.
struct MeshQuality {
  Index triangles = 0;
  Index edges = 0;
  Index inverted = 0;  ///< triangles that are not counter-clockwise, flat ones among them
  double area = 0;     ///< sum of the signed areas
  double min_angle = 0;
  double mean_edge = 0, min_edge = 0, max_edge = 0;
  double edge_deviation = 0;  ///< standard deviation of the edge lengths
  double min_area = 0, max_area = 0;
  double area_deviation = 0;  ///< standard deviation of the triangles' areas
};

/// REQUIRES triangles to index `rest`. An empty mesh has all zeros.
MeshQuality quality_of(std::span<const Vec2> rest, std::span<const Tri> triangles);

/// The least angle of a triangle, radians; 0 when it is flat or inverted.
double least_angle(Vec2 a, Vec2 b, Vec2 c);

}  // namespace toile::mesh
