#include "core/solver/constraints/air.h"

#include <gtest/gtest.h>

#include "tests/core/solver/strip.h"

namespace toile {
namespace {

/// A sheet of 0.2 kg/m² lying at height 1 in air.
solver::ClothSolver sheet_in(const solver::constraints::AirDrag& air, double time_step) {
  material::Fabric fabric;
  fabric.areal_mass = 0.2;
  const test::Strip strip = test::make_strip({0, 100}, 100, 0.02, {0, 1}, fabric);
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) x.push_back({p.x, 1, p.y});
  solver::ClothSolver solver(strip.model, x, {}, time_step);
  solver::ClothFeatures features;
  features.air = air;
  solver.set_features(features);
  return solver;
}

solver::StepForces in_air(double gravity) {
  solver::StepForces forces;
  forces.gravity = gravity;
  forces.damping = 0;
  forces.features.air = true;
  return forces;
}

Vec3 mean(std::span<const Vec3> of) {
  Vec3 sum;
  for (const Vec3& p : of) sum += p;
  return sum * (1.0 / static_cast<double>(of.size()));
}

TEST(Air, ASheetFallsFaceOnAtItsTerminalSpeed) {
  solver::ClothSolver solver = sheet_in({1.2, 1.2, 0.05, {}}, 1.0 / 2000);
  for (int i = 0; i < 3000; ++i) solver.step(in_air(9.81));
  const double expected = std::sqrt(2 * 0.2 * 9.81 / (1.2 * 1.2));
  EXPECT_NEAR(-mean(solver.velocities()).y / expected, 1, 0.01);
}

TEST(Air, AnUprightSheetFallsOnAlmostFreely) {
  solver::ClothSolver solver = sheet_in({1.2, 1.2, 0.05, {}}, 1.0 / 2000);
  solver::StepForces still = in_air(0);
  solver.set_velocities(std::vector<Vec3>(solver.positions().size(), Vec3{1, 0, 0}));
  for (int i = 0; i < 2000; ++i) solver.step(still);
  // dv/dt = −½ ρ C v² / m along the sheet, from 1 m/s over 1 s.
  EXPECT_NEAR(mean(solver.velocities()).x, 1 / (1 + 0.5 * 1.2 * 0.05 / 0.2), 0.01);
}

TEST(Air, ThickAirStopsASheetAndNeverThrowsItBack) {
  solver::ClothSolver solver = sheet_in({1e9, 1.2, 0.05, {}}, 0.01);
  solver.set_velocities(std::vector<Vec3>(solver.positions().size(), Vec3{3, -5, 0}));
  for (int i = 0; i < 20; ++i) {
    solver.step(in_air(0));
    const Vec3 v = mean(solver.velocities());
    EXPECT_LE(v.y, 1e-9);
    EXPECT_GE(v.x, -1e-9);
    EXPECT_LT(length(v), 6);
  }
  EXPECT_LT(length(mean(solver.velocities())), 0.01);
}

TEST(Air, WindTakesASheetAlongAndNeverBeyondItsOwnSpeed) {
  solver::ClothSolver solver = sheet_in({1.2, 1.2, 0.05, {0, 2, 0}}, 1.0 / 500);
  double fastest = 0;
  for (int i = 0; i < 2000; ++i) {
    solver.step(in_air(0));
    fastest = std::max(fastest, mean(solver.velocities()).y);
  }
  EXPECT_GT(fastest, 1.8);
  EXPECT_LE(fastest, 2 + 1e-9);
}

}  // namespace
}  // namespace toile
