#pragma once
// Small sheets for the tests of the paper's method: squares of a centimetre, halved.

#include <numeric>

#include "core/paper/particles.h"

namespace toile::test {

/// `columns` by `rows` squares, rows of vertices from below, x to the right.
inline sewing::GarmentMesh sheet(int columns, int rows) {
  sewing::GarmentMesh g;
  const Index wide = columns + 1;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) g.rest.push_back({0.01 * c, 0.01 * r});
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < columns; ++c) {
      const Index a = r * wide + c, b = a + 1, d = a + wide, e = d + 1;
      g.triangles.push_back({a, b, e});
      g.triangles.push_back({a, e, d});
    }
  }
  g.panel_of_vertex.assign(g.rest.size(), 0);
  g.panel_of_triangle.assign(g.triangles.size(), 0);
  g.first_vertex = {0, g.vertex_count()};
  g.weld.resize(g.rest.size());
  std::iota(g.weld.begin(), g.weld.end(), 0);
  return g;
}

/// Two of them, the right border of one sewn to the left one of the other.
inline sewing::GarmentMesh two_sheets(int columns, int rows) {
  sewing::GarmentMesh g = sheet(columns, rows);
  const sewing::GarmentMesh other = g;
  const Index count = g.vertex_count();
  g.rest.insert(g.rest.end(), other.rest.begin(), other.rest.end());
  for (const Tri& t : other.triangles) g.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  g.panel_of_vertex.insert(g.panel_of_vertex.end(), other.rest.size(), 1);
  g.panel_of_triangle.insert(g.panel_of_triangle.end(), other.triangles.size(), 1);
  g.first_vertex.push_back(g.vertex_count());
  g.weld.resize(g.rest.size());
  std::iota(g.weld.begin(), g.weld.end(), 0);
  for (Index r = 0; r <= rows; ++r) {
    const Index left = r * (columns + 1) + columns, right = count + r * (columns + 1);
    g.sewn.push_back({left, right});
    g.seam_of_sewn.push_back(0);
    g.weld[right] = left;
  }
  return g;
}

inline paper::Particles particles_of(const sewing::GarmentMesh& g, const material::Fabric& fabric,
                                     double load = 2) {
  const std::size_t panels = g.first_vertex.size() - 1;
  const std::vector<Vec2> warps(panels, {0, 1});
  return paper::make_particles(g, warps, {{fabric}}, std::vector<Index>(panels, 0), load);
}

/// Flat in the plane z = 0.
inline std::vector<Vec3> lifted(const sewing::GarmentMesh& g) {
  std::vector<Vec3> x;
  for (const Vec2 p : g.rest) x.push_back({p.x, p.y, 0});
  return x;
}

}  // namespace toile::test
