#include "core/trials/tube.h"

#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/solver/cloth_solver.h"
#include "core/solver/constraints/membrane.h"
#include "core/trials/specimen.h"

namespace toile::trials {
namespace {

constexpr double kRadius = 0.05, kTubeLength = 0.15, kTubeSpacing = 0.008;  // m
constexpr double kAround = 2 * kPi * kRadius;
constexpr double kTubeStrain = 0.005;
constexpr double kTubeWaves2 = 550;  // m²/s², as in tension.cpp

bool is_middle(double along) { return std::abs(along - kTubeLength / 2) < kTubeLength / 6; }

/// Means over the middle third.
struct Middle {
  double radius = 0, strain = 0;  ///< m, around
};

Middle middle_of(const Specimen& tube, const std::vector<Vec3>& x, bool warp_around) {
  Middle sum;
  double vertices = 0, triangles = 0;
  const auto membrane = solver::constraints::make_membrane(tube.model);
  for (const Vec3& p : x) {
    if (!is_middle(p.y)) continue;
    sum.radius += std::hypot(p.x, p.z);
    vertices += 1;
  }
  for (const auto& triangle : membrane) {
    if (!is_middle((x[triangle.v[0]].y + x[triangle.v[1]].y + x[triangle.v[2]].y) / 3)) continue;
    const Vec3 strain = solver::constraints::membrane_strain(triangle, x);
    sum.strain += warp_around ? strain.y : strain.x;
    triangles += 1;
  }
  return {sum.radius / vertices, sum.strain / triangles};
}

}  // namespace

TubeResult tube(const material::Fabric& fabric, bool warp_around) {
  constexpr double kRate = 9000, kSeconds = 0.8;
  const double own = warp_around ? fabric.stretch_warp : fabric.stretch_weft;
  const double other = warp_around ? fabric.stretch_weft : fabric.stretch_warp;
  TubeResult out;
  // Strain around under a tension T around and T / 2 along, which the caps pull with.
  const double coupling = fabric.stretch_coupling;
  out.known = (own * other - coupling * coupling) / (other - coupling / 2);
  material::Fabric light = fabric;
  light.areal_mass = out.known / kTubeWaves2;
  const Vec2 warp = warp_around ? Vec2{1, 0} : Vec2{0, 1};
  const Specimen specimen =
      make_ring(rectangle(mm_from_metres(kAround), mm_from_metres(kTubeLength), warp), kTubeSpacing, light);
  std::vector<Vec3> x;
  for (const Vec2& p : specimen.rest)
    x.push_back({kRadius * std::sin(p.x / kRadius), p.y, kRadius * std::cos(p.x / kRadius)});
  const double pressure = out.known * kTubeStrain / kRadius;
  solver::ClothFeatures air;
  air.chambers = {solver::constraints::make_chamber(specimen.model.triangles, specimen.model.vertex_count(),
                                                    pressure, 0)};
  solver::ClothSolver solver(specimen.model, std::move(x), {}, 1 / kRate);
  solver.set_features(std::move(air));
  solver::StepForces forces;
  forces.gravity = 0;
  forces.damping = 20;
  run(solver, forces, kSeconds);
  const Middle middle = middle_of(specimen, solver.positions(), warp_around);
  out.measured = pressure * middle.radius / middle.strain;
  return out;
}

}  // namespace toile::trials
