#include "core/drape/shoulder_holds.h"

#include <algorithm>
#include <cmath>

#include "core/dressing/staging.h"

namespace toile::drape {

namespace {
/// Shares of the ridge, from the neck to the shoulder's outer end, between which cloth is kept; m to front
/// and back of it, and beneath.
constexpr double kFrom = 0, kTo = 1.4, kAcross = 0.06, kBelow = 0.03;
/// Share of the ridge that nothing is drawn farther in than: pieces that were arranged one by one may stand
/// nearer to the middle than they are worn.
constexpr double kInnermost = 0.9;
/// Share of the ridge within which cloth is at the neck: its garment cannot slide off.
constexpr double kAtNeck = 0.3;
}  // namespace

std::vector<solver::constraints::ShoulderHold> make_shoulder_holds(const sewing::Assembly& assembly,
                                                                   const measure::BodyFigure& figure,
                                                                   std::span<const Index> vertex_of,
                                                                   Index vertex_count) {
  const sewing::GarmentMesh& g = assembly.garment;
  const std::vector<dressing::Covers> covers = dressing::covers_of(assembly, figure);
  std::vector<double> aside(static_cast<std::size_t>(vertex_count), -1);
  for (Index i = 0; i < g.vertex_count(); ++i) {
    if (covers[static_cast<std::size_t>(g.panel_of_vertex[i])] == dressing::Covers::kArm) continue;
    double& far = aside[vertex_of[i]];
    far = std::max(far, std::abs(assembly.positions[i].x - figure.middle));
  }
  std::vector<solver::constraints::ShoulderHold> holds;
  for (const std::size_t side : {measure::kWearersLeft, measure::kWearersRight}) {
    const Vec3 neck = figure.neck_side[side], ridge = figure.shoulder[side] - neck;
    const double least = std::abs(neck.x + kInnermost * ridge.x - figure.middle);
    solver::constraints::ShoulderHold hold{figure.middle, neck,   ridge,   kFrom, kTo,
                                           kAcross,       kBelow, kAtNeck, {}};
    for (Index v = 0; v < vertex_count; ++v)
      if (aside[v] >= 0) hold.held.push_back({v, std::max(least, aside[v])});
    holds.push_back(std::move(hold));
  }
  return holds;
}

}  // namespace toile::drape
