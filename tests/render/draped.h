#pragma once
// Cloth to take pictures of: a skirt with sinusoidal folds from two sewn pieces, and a form under it.

#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "server/render/scene.h"

namespace toile {

struct Draped {
  std::vector<Vec3> positions;
  std::vector<Tri> triangles;
  std::vector<Index> panel_of_triangle, weld;
  std::vector<Vec2> rest;

  render::Scene scene() const {
    render::Scene s;
    s.cloth = {positions, triangles, panel_of_triangle, weld, {{0.5, 0.1, 0.1}, {0.1, 0.1, 0.5}}, rest};
    return s;
  }
};

inline constexpr int kSkirtColumns = 40, kSkirtRows = 20;  // of each piece

/// Panel 0 is the front half (z > 0), panel 1 the back; waist at 1 m, hem at 0.5 m.
inline Draped folded_skirt() {
  Draped d;
  for (int panel = 0; panel < 2; ++panel) {
    const auto first = static_cast<Index>(d.positions.size());
    for (int j = 0; j <= kSkirtRows; ++j) {
      for (int i = 0; i <= kSkirtColumns; ++i) {
        const double angle = kPi * (panel + static_cast<double>(i) / kSkirtColumns) - kPi / 2;
        const double down = static_cast<double>(j) / kSkirtRows;
        const double radius = 0.13 + 0.1 * down + 0.02 * down * std::sin(8 * angle);
        d.positions.push_back({radius * std::sin(angle), 1 - 0.5 * down, radius * std::cos(angle)});
        d.rest.push_back({0.15 * angle, -0.5 * down});
        d.weld.push_back(static_cast<Index>(d.weld.size()));
      }
    }
    for (int j = 0; j < kSkirtRows; ++j) {
      for (int i = 0; i < kSkirtColumns; ++i) {
        const Index a = first + j * (kSkirtColumns + 1) + i, b = a + 1, c = a + kSkirtColumns + 1, e = c + 1;
        d.triangles.push_back({a, c, b});
        d.triangles.push_back({b, c, e});
        d.panel_of_triangle.insert(d.panel_of_triangle.end(), 2, panel);
      }
    }
  }
  const Index back = static_cast<Index>(d.positions.size()) / 2;
  for (int j = 0; j <= kSkirtRows; ++j) {  // sew the sides: the end of each piece to the start of the other
    const Index row = j * (kSkirtColumns + 1);
    d.weld[back + row] = row + kSkirtColumns;
    d.weld[back + row + kSkirtColumns] = row;
  }
  return d;
}

/// An upright box from the floor to 1.6 m, outward normals.
inline geometry::TriangleMesh form() {
  geometry::TriangleMesh m;
  for (int i = 0; i < 8; ++i) {
    m.vertices.push_back({(i & 1) ? 0.09 : -0.09, (i & 2) ? 1.6 : 0.0, (i & 4) ? 0.09 : -0.09});
  }
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 4, 2}, {2, 4, 6},
                 {1, 3, 5}, {3, 7, 5}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}};
  return m;
}

}  // namespace toile
