#include "core/trials/shear.h"

#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/solver/cloth_solver.h"
#include "core/trials/slope.h"
#include "core/trials/specimen.h"

namespace toile::trials {
namespace {

constexpr double kShearLength = 0.05, kShearWidth = 0.2,
                 kShearSpacing = 0.004;  // m, between the held sides and along them
constexpr double kMostShear = 0.0087;    // radians, beside the held sides
/// Load is weight, as in tension.cpp, with waves of shear at 8 m/s: those of stretch are several times
/// faster.
constexpr double kShearWaves2 = 64,
                 kShearGravity = kMostShear * kShearWaves2 / (kShearLength / 2);  // m²/s², m/s²

/// Of u = a + b (q − L/2)² through the middle half of the piece, b; by least squares.
double sag_of(const Specimen& piece, const std::vector<Vec3>& x) {
  std::vector<Vec2> sunk;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec2 rest = piece.rest[i];
    const double q = rest.x - kShearLength / 2;
    if (std::abs(rest.y - kShearWidth / 2) <= kShearWidth / 4)  // free ends carry no shear
      sunk.push_back({q * q, x[i].y - rest.y});
  }
  return slope_of(sunk);
}

}  // namespace

ShearResult shear(const material::Fabric& fabric) {
  constexpr double kRate = 12000, kSeconds = 0.8;
  ShearResult out;
  out.known = fabric.stretch_shear;
  material::Fabric loaded = fabric;
  loaded.areal_mass = out.known / kShearWaves2;
  const Specimen piece = make_specimen(
      rectangle(mm_from_metres(kShearLength), mm_from_metres(kShearWidth), {0, 1}), kShearSpacing, loaded);
  std::vector<Vec3> x;
  std::vector<solver::constraints::HeldVertex> held;
  for (const Vec2& p : piece.rest) {
    x.push_back({p.x, p.y, 0});
    if (p.x < 1e-6 || p.x > kShearLength - 1e-6)
      held.push_back({static_cast<Index>(x.size()) - 1, false, x.back()});
  }
  solver::ClothSolver solver(piece.model, std::move(x), {}, 1 / kRate);
  solver.set_holds(std::move(held));
  solver::StepForces forces;
  forces.gravity = kShearGravity;
  forces.damping = 40;
  run(solver, forces, kSeconds);
  // G u'' = w: the sag's second derivative carries the weight of each mm of cloth.
  out.measured = loaded.areal_mass * kShearGravity / (2 * sag_of(piece, solver.positions()));
  return out;
}

}  // namespace toile::trials
