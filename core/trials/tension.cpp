#include "core/trials/tension.h"

#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/solver/cloth_solver.h"
#include "core/trials/slope.h"
#include "core/trials/specimen.h"

namespace toile::trials {
namespace {

constexpr double kStripLength = 0.2, kStripWidth = 0.05, kStripSpacing = 0.01;  // m
constexpr double kStripStrain = 0.005;                                          // at the middle
/// Load is weight: the strip is given the mass at which waves run along it at 23 m/s, which short steps
/// follow, and the gravity that stretches it as wanted.
constexpr double kStripWaves2 = 550,
                 kStripGravity = kStripStrain * kStripWaves2 / (kStripLength / 2);  // m²/s², m/s²

/// Slope of the displacement over the height in the middle half of the strip, by least squares.
double strain_of(const Specimen& strip, const std::vector<Vec3>& x) {
  std::vector<Vec2> sunk;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double q = strip.rest[i].x - kStripLength / 2;
    if (std::abs(q) <= kStripLength / 4) sunk.push_back({q, -x[i].y - strip.rest[i].x});
  }
  return slope_of(sunk);
}

}  // namespace

TensionResult tension(const material::Fabric& fabric, bool along_warp) {
  constexpr double kRate = 9000, kSeconds = 0.8;
  const double own = along_warp ? fabric.stretch_warp : fabric.stretch_weft;
  const double other = along_warp ? fabric.stretch_weft : fabric.stretch_warp;
  TensionResult out;
  out.known = own - fabric.stretch_coupling * fabric.stretch_coupling / other;
  material::Fabric loaded = fabric;
  loaded.areal_mass = out.known / kStripWaves2;
  const Vec2 warp = along_warp ? Vec2{1, 0} : Vec2{0, 1};
  const Specimen strip = make_specimen(
      rectangle(mm_from_metres(kStripLength), mm_from_metres(kStripWidth), warp), kStripSpacing, loaded);
  std::vector<Vec3> x;
  std::vector<solver::constraints::HeldVertex> held;
  for (const Vec2& p : strip.rest) {  // hung by its end at x = 0
    x.push_back({p.y, -p.x, 0});
    if (p.x < 1e-6) held.push_back({static_cast<Index>(x.size()) - 1, false, x.back()});
  }
  solver::ClothSolver solver(strip.model, std::move(x), {}, 1 / kRate);
  solver.set_holds(std::move(held));
  solver::StepForces forces;
  forces.gravity = kStripGravity;
  forces.damping = 20;
  run(solver, forces, kSeconds);
  const double load = loaded.areal_mass * kStripGravity * kStripLength / 2;  // N/m, at the middle
  out.measured = load / strain_of(strip, solver.positions());
  return out;
}

}  // namespace toile::trials
