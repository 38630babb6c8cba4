#include "core/trials/specimen.h"

#include <numeric>
#include <string>

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

Specimen make_specimen(const pattern::Panel& panel, double spacing, const material::Fabric& fabric) {
  pattern::Pattern pattern;
  pattern.panels = {panel};
  const mesh::PanelMeshes meshes = mesh::make_panel_meshes(pattern, spacing, RunContext{}).value();
  const std::vector<sewing::Placement> flat{sewing::RigidPlacement{}};
  const sewing::GarmentMesh garment = sewing::assemble(meshes, flat, {}).value().garment;
  std::vector<Index> vertex_of(garment.rest.size());
  std::iota(vertex_of.begin(), vertex_of.end(), 0);
  const Index only = 0;
  return {garment.rest,
          solver::make_cloth_model(garment, vertex_of, garment.vertex_count(), std::span(&panel.grain, 1),
                                   std::span(&fabric, 1), std::span(&only, 1))};
}

}  // namespace toile::trials
