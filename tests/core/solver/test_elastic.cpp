#include "core/solver/constraints/elastic.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/solver/strip.h"

namespace toile {
namespace {

/// Bands along the vertices of a strip that stand at x = `at`, m.
void add_band(const test::Strip& strip, double at, double factor, double stiffness,
              std::vector<solver::constraints::ElasticSegment>& out) {
  std::vector<Index> line;
  for (std::size_t i = 0; i < strip.rest.size(); ++i) {
    if (std::abs(strip.rest[i].x - at) < 1e-9) line.push_back(static_cast<Index>(i));
  }
  std::sort(line.begin(), line.end(), [&](Index a, Index b) { return strip.rest[a].y < strip.rest[b].y; });
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double flat = strip.rest[line[i + 1]].y - strip.rest[line[i]].y;
    out.push_back({line[i], line[i + 1], flat, factor * flat, stiffness});
  }
}

/// Length of a hung strip of 60 × 200 mm with bands on both sides, at rest, m.
double hung_length(const material::Fabric& fabric, double factor, double stiffness) {
  const test::Strip strip = test::make_strip({0, 60}, 200, 0.012, {0, 1}, fabric);
  std::vector<Vec3> x;
  std::vector<solver::constraints::HeldVertex> held;
  for (const Vec2& p : strip.rest) {
    x.push_back({p.x, p.y, 0});
    if (p.y > 0.1999) held.push_back({static_cast<Index>(x.size()) - 1, false, x.back()});
  }
  solver::ClothSolver solver(strip.model, x, {}, 1.0 / 4000);
  solver.set_holds(held);
  solver::ClothFeatures features;
  add_band(strip, 0, factor, stiffness, features.elastics);
  add_band(strip, 0.06, factor, stiffness, features.elastics);
  solver.set_features(features);
  solver::StepForces forces;
  forces.damping = 10;
  for (int i = 0; i < 6000; ++i) solver.step(forces);
  double lowest = 1;
  for (const Vec3& p : solver.positions()) lowest = std::min(lowest, p.y);
  return 0.2 - lowest;
}

material::Fabric weak_cloth(double stiffness) {
  material::Fabric fabric;
  fabric.areal_mass = 1;
  fabric.stretch_warp = fabric.stretch_weft = stiffness;
  fabric.stretch_coupling = 0;
  fabric.stretch_shear = 200;
  return fabric;
}

TEST(Elastic, BandsShareALoadWithTheirClothAsStiffnessSays) {
  // Tension T(y) = weight below; strain T / (K·width + 2 k); its mean is that of half the weight.
  const double weight = 1 * 0.06 * 0.2 * 9.81, together = 20 * 0.06 + 2 * 0.8;
  const double expected = 0.2 * (weight / 2) / together;
  EXPECT_NEAR((hung_length(weak_cloth(20), 1, 0.8) - 0.2) / expected, 1, 0.05);
}

TEST(Elastic, AShorterBandFindsTheLengthAtWhichClothAndBandPullAlike) {
  // Without load: cloth and band would lie between their lengths; hung, the cloth is taut where the weight
  // exceeds what the bands carry. A heavy load: length L with K·width (L/L0 − 1) + 2 k (L/(f L0) − 1) = W/2.
  const double weight = 1 * 0.06 * 0.2 * 9.81, k = 0.15, f = 0.9, cloth = 20 * 0.06;
  const double expected = 0.2 * (weight / 2 + cloth + 2 * k) / (cloth + 2 * k / f);
  EXPECT_NEAR(hung_length(weak_cloth(20), f, k) / expected, 1, 0.005);
}

TEST(Elastic, ABandNeverPushes) {
  std::vector<Vec3> x{{0, 0, 0}, {0.005, 0, 0}};
  const std::vector<Vec3> before = x;
  solver::constraints::solve_elastics(
      std::vector<solver::constraints::ElasticSegment>{{0, 1, 0.02, 0.01, 50}}, 1, std::vector{1.0, 1.0},
      1e-3, x);
  EXPECT_EQ(x, before);
}

}  // namespace
}  // namespace toile
