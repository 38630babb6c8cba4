#pragma once
// The gap between two triangles, feature by feature.

#include <array>

#include "core/base/types.h"

namespace toile::preflight {

/// A triangle in space; corners of two triangles that bear the same class are one vertex of the garment.
struct GapTriangle {
  std::array<Vec3, 3> x;      ///< m
  std::array<Index, 3> type;  ///< class of each corner
};

/// Distance of the two triangles' features (corner to face, edge to edge), m; 0 where they cross. Features
/// that share a vertex are neighbours and are left out; 1 when nothing is left.
double triangle_gap(const GapTriangle& a, const GapTriangle& b);

/// Whether an edge of one passes through the inside of the other, exactly. Sharing two vertices they cannot.
bool triangles_cross(const GapTriangle& a, const GapTriangle& b);

}  // namespace toile::preflight
