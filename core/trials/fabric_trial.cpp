#include "core/trials/fabric_trial.h"

#include <algorithm>
#include <cmath>

namespace toile::trials {

double FabricTrial::coefficient() const {
  double sum = 0;
  for (const CusickDrape& drape : drapes) sum += drape.shadow.coefficient;
  return sum / static_cast<double>(drapes.size());
}

double FabricTrial::spread() const {
  const auto [least, most] = std::minmax_element(
      drapes.begin(), drapes.end(),
      [](const CusickDrape& a, const CusickDrape& b) { return a.shadow.coefficient < b.shadow.coefficient; });
  return most->shadow.coefficient - least->shadow.coefficient;
}

double FabricTrial::nodes() const {
  double sum = 0;
  for (const CusickDrape& drape : drapes) sum += drape.shadow.nodes;
  return sum / static_cast<double>(drapes.size());
}

int FabricTrial::settled() const {
  return static_cast<int>(
      std::count_if(drapes.begin(), drapes.end(), [](const auto& d) { return d.settled; }));
}

Result<FabricTrial> try_fabric(const material::Fabric& fabric, int drapes, double particle_distance,
                               const RunContext& context) {
  const double half = std::sqrt(0.5);
  FabricTrial out;
  out.particle_distance = particle_distance > 0 ? particle_distance : fabric::fitting_distance(fabric);
  out.warp = cantilever(fabric, {0, 1}, fabric.bend_warp);
  out.weft = cantilever(fabric, {1, 0}, fabric.bend_weft);
  out.bias = cantilever(fabric, {half, half}, fabric.bend_bias);
  out.pull_warp = tension(fabric, true);
  out.pull_weft = tension(fabric, false);
  out.shear = shear(fabric);
  out.tube_warp = tube(fabric, true);
  out.tube_weft = tube(fabric, false);
  out.slide = slide(fabric);
  RunContext quiet;
  quiet.cancel = context.cancel;
  for (int i = 0; i < drapes; ++i) {
    context.progress("test", static_cast<double>(i) / drapes);
    out.drapes.push_back(TRY(cusick_drape(fabric, i, out.particle_distance, quiet)));
  }
  context.progress("test", 1);
  return out;
}

}  // namespace toile::trials
