#pragma once
// The cloth as the solver sees it: vertices (welded ones merged), triangles with their rest shapes, masses.

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/material/fabric.h"
#include "core/sewing/garment_mesh.h"

namespace toile::solver {

/// Rest corners of a triangle, metres: x along the weft, y along the warp.
using RestTriangle = std::array<Vec2, 3>;

struct ClothModel {
  std::vector<Tri> triangles;
  std::vector<RestTriangle> rest;
  std::vector<Index> fabric_of_triangle;  ///< into `fabrics`
  std::vector<material::Fabric> fabrics;
  std::vector<double> mass;         ///< kg per vertex: a third of each triangle around it
  std::vector<Index> vertex_class;  ///< stitched vertices share a class: least member's index

  Index vertex_count() const { return static_cast<Index>(mass.size()); }
};

/// Area of a rest triangle, m², positive.
double rest_area(const RestTriangle& rest);

/// Makes the model of a garment. `vertex_of[i]` is the solver's vertex of garment vertex i (welded vertices
/// have the same); `warps` and `fabric_of_panel` have one entry a panel.
ClothModel make_cloth_model(const sewing::GarmentMesh& garment, std::span<const Index> vertex_of,
                            Index vertex_count, std::span<const Vec2> warps,
                            std::span<const material::Fabric> fabrics,
                            std::span<const Index> fabric_of_panel);

}  // namespace toile::solver
