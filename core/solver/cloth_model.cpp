#include "core/solver/cloth_model.h"

#include <algorithm>

namespace toile::solver {

double rest_area(const RestTriangle& rest) {
  return 0.5 * std::abs(cross(rest[1] - rest[0], rest[2] - rest[0]));
}

namespace {

/// Classes of solver vertices from the classes of garment vertices: least solver vertex of each.
std::vector<Index> classes_of(const sewing::GarmentMesh& garment, std::span<const Index> vertex_of,
                              Index vertex_count) {
  std::vector<Index> least(garment.vertex_count(), vertex_count);
  for (Index i = 0; i < garment.vertex_count(); ++i) {
    least[garment.weld[i]] = std::min(least[garment.weld[i]], vertex_of[i]);
  }
  std::vector<Index> classes(vertex_count);
  for (Index i = 0; i < garment.vertex_count(); ++i) classes[vertex_of[i]] = least[garment.weld[i]];
  return classes;
}

}  // namespace

ClothModel make_cloth_model(const sewing::GarmentMesh& garment, std::span<const Index> vertex_of,
                            Index vertex_count, std::span<const Vec2> warps,
                            std::span<const material::Fabric> fabrics,
                            std::span<const Index> fabric_of_panel) {
  ClothModel model;
  model.fabrics.assign(fabrics.begin(), fabrics.end());
  model.mass.assign(vertex_count, 0);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const Index panel = garment.panel_of_triangle[t];
    const Vec2 warp = warps[panel], weft{warp.y, -warp.x};
    Tri triangle{};
    RestTriangle rest;
    for (int k = 0; k < 3; ++k) {
      const Vec2 p = garment.rest[garment.triangles[t][k]];
      triangle[k] = vertex_of[garment.triangles[t][k]];
      rest[k] = {dot(p, weft), dot(p, warp)};
    }
    const Index fabric = fabric_of_panel[panel];
    for (const Index v : triangle) model.mass[v] += rest_area(rest) * fabrics[fabric].areal_mass / 3;
    model.triangles.push_back(triangle);
    model.rest.push_back(rest);
    model.fabric_of_triangle.push_back(fabric);
  }
  model.vertex_class = classes_of(garment, vertex_of, vertex_count);
  return model;
}

}  // namespace toile::solver
