#include "core/solver/constraints/restitution.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/solver/cloth_solver.h"
#include "tests/core/solver/strip.h"

namespace toile {
namespace {

constexpr double kFallStep = 1.0 / 3000;
constexpr double kDrop = 0.05;  // m

collision::Obstacle floor_of(double restitution) {
  const std::vector<Vec3> x{{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}, {1, 0, 1}};
  return collision::make_obstacle(x, std::vector<Tri>{{0, 2, 1}, {1, 2, 3}}, 0.4, 1e-3, restitution);
}

double mean_height(const std::vector<Vec3>& x) {
  double sum = 0;
  for (const Vec3& p : x) sum += p.y;
  return sum / static_cast<double>(x.size());
}

/// What became of a flat square that fell on a floor.
struct Fall {
  double lowest = 1, rebound = 0;  ///< m above where cloth rests; the latter after the first impact
  double fastest_up = 0;           ///< m/s
  std::vector<Vec3> end;
};

Fall fall(double restitution, double seconds, double factor = 1) {
  const test::Strip strip = test::make_strip({0, 100}, 100, 0.02, {0, 1}, material::Fabric{});
  const std::vector<collision::Obstacle> obstacles{floor_of(restitution)};
  solver::ClothSolver solver(strip.model, lying(strip, kDrop + 1e-3), obstacles, kFallStep);
  solver::StepForces forces;
  forces.damping = 0;
  forces.restitution = factor;
  Fall out;
  bool struck = false;
  for (int i = 0; i < seconds / kFallStep; ++i) {
    solver.step(forces);
    const double y = mean_height(solver.positions()) - 1e-3;
    struck = struck || y < 1e-3;
    out.lowest = std::min(out.lowest, y);
    if (struck) out.rebound = std::max(out.rebound, y);
    for (const Vec3& v : solver.velocities()) out.fastest_up = std::max(out.fastest_up, v.y);
    for (const Vec3& p : solver.positions()) EXPECT_GT(p.y, 0) << "through the floor";
  }
  out.end = solver.positions();
  return out;
}

TEST(Bounce, ClothStaysOnAFloorWithoutRestitution) {
  const Fall f = fall(0, 0.4);
  EXPECT_LT(f.rebound, 2e-3);
  EXPECT_LT(f.fastest_up, 0.1);
}

TEST(Bounce, ClothLeavesAHardFloorAsFastAsItCame) {
  const Fall f = fall(1, 0.21);  // 0.1 s down, 0.1 s up
  EXPECT_GT(f.rebound, 0.85 * kDrop);
  EXPECT_LT(f.rebound, 1.02 * kDrop) << "no height may be won";
}

TEST(Bounce, ReboundRisesWithTheSquareOfTheRestitution) {
  const Fall f = fall(0.6, 0.21);
  EXPECT_NEAR(f.rebound, 0.36 * kDrop, 0.06 * kDrop);
}

TEST(Bounce, ComesToRestInTheEnd) {
  const Fall f = fall(0.5, 1.0);
  for (const Vec3& p : f.end) EXPECT_LT(p.y, 1.5e-3);
}

TEST(Bounce, CanBeTurnedOffForAStep) { EXPECT_EQ(fall(1, 0.2, 0).end, fall(0, 0.2).end); }

TEST(Bounce, ThrowsBackOnlyWhatStrikesAtSpeed) {
  collision::Contact c;
  c.count = 1;
  c.v[0] = 0;
  c.w[0] = 1;
  c.n = {0, 1, 0};
  c.rest = 1e-3;
  c.restitution = 0.5;
  const std::vector<collision::Contact> contacts{c};
  const std::vector<double> inverse_mass{2.0};
  const std::vector<Vec3> near{{0, 0.5e-3, 0}}, far{{0, 2e-3, 0}};
  const std::vector<Vec3> fast{{3, -1, 0}}, slow{{3, -0.9 * solver::constraints::kLeastImpact, 0}},
      away{{0, 1, 0}};
  EXPECT_EQ(solver::constraints::find_impacts(contacts, 1, near, fast).size(), 1u);
  EXPECT_TRUE(solver::constraints::find_impacts(contacts, 1, far, fast).empty()) << "it is not there yet";
  EXPECT_TRUE(solver::constraints::find_impacts(contacts, 1, near, slow).empty());
  EXPECT_TRUE(solver::constraints::find_impacts(contacts, 1, near, away).empty());
  EXPECT_TRUE(solver::constraints::find_impacts(contacts, 0, near, fast).empty());
  std::vector<Vec3> after{{3, 0, 0}};
  const std::vector<solver::constraints::Impact> impacts =
      solver::constraints::find_impacts(contacts, 1, near, fast);
  solver::constraints::give_back(impacts, inverse_mass, after);
  EXPECT_EQ(after[0], (Vec3{3, 0.5, 0})) << "along the normal, whatever it weighs";
  solver::constraints::give_back(impacts, inverse_mass, after);
  EXPECT_EQ(after[0], (Vec3{3, 0.5, 0})) << "not twice";
}

TEST(Bounce, GivesALayersPartsTheirShares) {
  collision::Contact c;  // the middle of an edge between a light and a held vertex
  c.count = 2;
  c.v[0] = 0;
  c.v[1] = 1;
  c.w[0] = c.w[1] = 0.5;
  c.n = {0, 1, 0};
  c.rest = 1e-3;
  c.restitution = 1;
  std::vector<Vec3> after(2);
  solver::constraints::give_back(std::vector<solver::constraints::Impact>{{&c, 1.0}},
                                 std::vector<double>{1.0, 0.0}, after);
  EXPECT_NEAR(0.5 * after[0].y + 0.5 * after[1].y, 1, 1e-12);
  EXPECT_EQ(after[1], Vec3{}) << "a held vertex is not thrown";
}

}  // namespace
}  // namespace toile
