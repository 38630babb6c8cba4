#include "core/analysis/strain.h"

#include <algorithm>
#include <cmath>

namespace toile::analysis {

namespace {

/// Deformation gradient's columns along weft and warp of one triangle.
Threads threads_of(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& x, Vec2 warp) {
  const Vec2 e1 = rest[1] - rest[0], e2 = rest[2] - rest[0];
  const Vec3 d1 = x[1] - x[0], d2 = x[2] - x[0];
  const double det = cross(e1, e2);
  // The image of a flat direction u: solve u = a e1 + b e2, then a d1 + b d2.
  const auto image = [&](Vec2 u) { return d1 * (cross(u, e2) / det) + d2 * (cross(e1, u) / det); };
  return {image({warp.y, -warp.x}), image(warp)};
}

}  // namespace

std::vector<Threads> garment_threads(const drape::DrapeInput& input, const drape::DrapeResult& result) {
  std::vector<Threads> out;
  const sewing::GarmentMesh& g = result.garment;
  out.reserve(g.triangles.size());
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const Tri& tri = g.triangles[t];
    out.push_back(threads_of({g.rest[tri[0]], g.rest[tri[1]], g.rest[tri[2]]},
                             {result.positions[tri[0]], result.positions[tri[1]], result.positions[tri[2]]},
                             input.pattern.panels[g.panel_of_triangle[t]].grain));
  }
  return out;
}

GarmentStrain garment_strain(const drape::DrapeInput& input, const drape::DrapeResult& result) {
  GarmentStrain out;
  for (const Threads& f : garment_threads(input, result)) {
    const double weft = length(f.weft), warp = length(f.warp);
    out.weft.push_back(weft - 1);
    out.warp.push_back(warp - 1);
    out.shear.push_back(weft > 0 && warp > 0 ? dot(f.weft, f.warp) / (weft * warp) : 0);
  }
  return out;
}

StrainFigures figures_of(std::vector<double> values) {
  if (values.empty()) return {};
  double sum = 0;
  for (double& v : values) {
    v = std::abs(v);
    sum += v;
  }
  std::sort(values.begin(), values.end());
  const auto at =
      std::min(values.size() - 1, static_cast<std::size_t>(0.99 * static_cast<double>(values.size())));
  return {sum / static_cast<double>(values.size()), values[at], values.back()};
}

StretchFigures stretch_figures_of(const std::vector<double>& values) {
  std::vector<double> stretch, squeeze;
  for (const double v : values) {
    stretch.push_back(std::max(0.0, v));
    squeeze.push_back(std::max(0.0, -v));
  }
  return {figures_of(values), figures_of(std::move(stretch)), figures_of(std::move(squeeze))};
}

}  // namespace toile::analysis
