#pragma once
// Rectangles of cloth for the physics tests: a row of pieces sewn side to side, as the solver sees them.

#include "core/base/crew.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/sewing/assembly.h"
#include "core/solver/cloth_solver.h"

namespace toile {

inline constexpr double kGravity = 9.81;  // m/s²

}  // namespace toile

namespace toile::test {

/// A line as a cubic.
inline pattern::CubicBezier line(Vec2 a, Vec2 b) {
  return {a, a + (b - a) * (1.0 / 3), a + (b - a) * (2.0 / 3), b};
}

/// A rectangle from x0 to x1 and 0 to height, mm; edges e0 (bottom), e1 (right), e2 (top), e3 (left).
inline pattern::Panel rectangle(double x0, double x1, double height, Vec2 grain) {
  pattern::Panel panel;
  panel.id = "from " + std::to_string(x0);
  panel.grain = grain;
  const Vec2 c[4] = {{x0, 0}, {x1, 0}, {x1, height}, {x0, height}};
  for (int k = 0; k < 4; ++k)
    panel.outline.edges.push_back({"e" + std::to_string(k), {line(c[k], c[(k + 1) % 4])}});
  return panel;
}

struct Strip {
  std::vector<Vec2> rest;  ///< m, of the solver's vertices
  solver::ClothModel model;
};

/// A strip of `height` mm with vertices on every x of `cuts` (mm, rising), triangles of about `h` metres.
inline Strip make_strip(std::vector<double> cuts, double height, double h, Vec2 grain,
                        const material::Fabric& fabric) {
  pattern::Pattern pattern;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    pattern.panels.push_back(rectangle(cuts[i], cuts[i + 1], height, grain));
    const auto panel = static_cast<Index>(i);
    if (i > 0) pattern.seams.push_back({"s", {{panel - 1, 1, false}}, {{panel, 3, false}}, false});
  }
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, h, RunContext{}).value();
  const std::vector<sewing::Placement> placements(pattern.panels.size(), sewing::RigidPlacement{});
  const sewing::GarmentMesh garment = sewing::assemble(meshes, placements, {}).value().garment;

  Strip strip;
  std::vector<Index> vertex_of(garment.rest.size());
  for (std::size_t i = 0; i < vertex_of.size(); ++i) {
    const bool first = garment.weld[i] == static_cast<Index>(i);
    if (first) strip.rest.push_back(garment.rest[i]);
    vertex_of[i] = first ? static_cast<Index>(strip.rest.size()) - 1 : vertex_of[garment.weld[i]];
  }
  const std::vector<Vec2> warps(pattern.panels.size(), grain);
  const std::vector<Index> fabrics(pattern.panels.size(), 0);
  strip.model = solver::make_cloth_model(garment, vertex_of, static_cast<Index>(strip.rest.size()), warps,
                                         std::span(&fabric, 1), fabrics);
  return strip;
}

/// Where its vertices are when it lies level.
inline std::vector<Vec3> lying(const Strip& strip, double y) {
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) x.push_back({p.x, y, p.y});
  return x;
}

/// One pass over positions as the rest of the program has them.
template <typename Pass>
void sweep(Pass& pass, std::vector<Vec3>& x,
           const solver::lanes::LaneKernels& kernels = solver::lanes::lane_kernels()) {
  std::vector<solver::lanes::LanePoint> points;
  Crew alone;
  solver::lanes::spread(x, points, alone);
  if constexpr (std::is_same_v<Pass, solver::lanes::MembranePass>) {
    pass.solve(points, false, alone, kernels);
  } else {
    pass.solve(points, alone, kernels);
  }
  solver::lanes::collect(points, x, alone);
}

}  // namespace toile::test
