#pragma once

#include <array>
#include <vector>

#include "core/base/types.h"

namespace toile::sewing {

/// The garment as one vertex list: panel after panel, each in the order of its PanelMesh. Sewn vertices are
/// not merged here; `sewn` and `weld` say which belong together.
struct GarmentMesh {
  std::vector<Vec2> rest;  ///< m, flat position of each vertex in its panel's frame
  std::vector<Tri> triangles;
  std::vector<Index> panel_of_vertex;
  std::vector<Index> panel_of_triangle;
  std::vector<Index> first_vertex;         ///< of each panel, and one past the last at the end
  std::vector<std::array<Index, 2>> sewn;  ///< pairs of vertices that seams join
  std::vector<Index> seam_of_sewn;         ///< index into Pattern::seams of each pair
  std::vector<Index> weld;  ///< least vertex that each vertex is sewn to, itself where it is not

  Index vertex_count() const { return static_cast<Index>(rest.size()); }
};

}  // namespace toile::sewing
