#include "core/trials/specimen.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/base/check.h"
#include "core/mesh/make_panel_meshes.h"
#include "core/sewing/assembly.h"

namespace toile::trials {
namespace {

pattern::CubicBezier straight(Vec2 a, Vec2 b) {
  return {a, a + (b - a) * (1.0 / 3), a + (b - a) * (2.0 / 3), b};
}

/// Handle of the cubic that comes nearest to a quarter of a circle of radius 1.
constexpr double kQuarter = 0.5522847498;

}  // namespace

pattern::Panel rectangle(double length, double width, Vec2 warp, double across) {
  pattern::Panel panel;
  panel.id = "strip";
  panel.grain = warp;
  const Vec2 c[4] = {{0, 0}, {length, 0}, {length, width}, {0, width}};
  for (std::size_t k = 0; k < 4; ++k)
    panel.outline.edges.push_back({"e" + std::to_string(k), {straight(c[k], c[(k + 1) % 4])}});
  if (across > 0) panel.lines.push_back({"clamp", {{across, 0}, {across, width}}, false});
  return panel;
}

pattern::Panel circle(double radius, Vec2 warp) {
  pattern::Panel panel;
  panel.id = "disc";
  panel.grain = warp;
  const Vec2 c[4] = {{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 a = c[k], b = c[(k + 1) % 4];
    panel.outline.edges.push_back({"e" + std::to_string(k), {{a, a + b * kQuarter, b + a * kQuarter, b}}});
  }
  return panel;
}

namespace {

sewing::GarmentMesh mesh_of(const pattern::Panel& panel, double spacing) {
  pattern::Pattern pattern;
  pattern.panels = {panel};
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, spacing, RunContext{}).value();
  const std::vector<sewing::Placement> flat{sewing::RigidPlacement{}};
  return sewing::assemble(meshes, flat, {}).value().garment;
}

solver::ClothModel model_of(const sewing::GarmentMesh& garment, std::span<const Index> vertex_of,
                            Index vertex_count, Vec2 warp, const material::Fabric& fabric) {
  const Index only = 0;
  return solver::make_cloth_model(garment, vertex_of, vertex_count, std::span(&warp, 1),
                                  std::span(&fabric, 1), std::span(&only, 1));
}

}  // namespace

Specimen make_specimen(const pattern::Panel& panel, double spacing, const material::Fabric& fabric) {
  const sewing::GarmentMesh garment = mesh_of(panel, spacing);
  std::vector<Index> vertex_of(garment.rest.size());
  std::iota(vertex_of.begin(), vertex_of.end(), 0);
  return {garment.rest, model_of(garment, vertex_of, garment.vertex_count(), panel.grain, fabric)};
}

Specimen make_ring(const pattern::Panel& rectangle, double spacing, const material::Fabric& fabric) {
  constexpr double kSame = 1e-6;  // m
  const sewing::GarmentMesh garment = mesh_of(rectangle, spacing);
  double length = 0;
  for (const Vec2& p : garment.rest) length = std::max(length, p.x);
  std::vector<Index> vertex_of(garment.rest.size(), kNone);
  std::vector<Vec2> rest;
  for (std::size_t i = 0; i < garment.rest.size(); ++i) {
    if (garment.rest[i].x > length - kSame) continue;
    vertex_of[i] = static_cast<Index>(rest.size());
    rest.push_back(garment.rest[i]);
  }
  for (std::size_t i = 0; i < garment.rest.size(); ++i) {
    if (vertex_of[i] != kNone) continue;
    const auto first = std::find_if(rest.begin(), rest.end(), [&](const Vec2& p) {
      return p.x < kSame && std::abs(p.y - garment.rest[i].y) < kSame;
    });
    TOILE_CHECK(first != rest.end());  // both ends are sampled alike
    vertex_of[i] = static_cast<Index>(first - rest.begin());
  }
  const auto count = static_cast<Index>(rest.size());
  return {std::move(rest), model_of(garment, vertex_of, count, rectangle.grain, fabric)};
}

void run(solver::ClothSolver& solver, const solver::StepForces& forces, double seconds) {
  for (double t = 0; t < seconds; t += solver.time_step()) solver.step(forces);
}

}  // namespace toile::trials
