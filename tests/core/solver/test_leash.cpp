// A leash is a spring, implicit in time, with a limited force.

#include "core/solver/constraints/leash.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

using solver::constraints::Leash;

constexpr double kLeashStep = 1.0 / 3000;  // s

/// One vertex of `mass` (kg) that hangs on a leash under `force` (N, upwards) until it is at rest.
double at_rest(double mass, double force, const Leash& leash) {
  std::vector<Vec3> x(3);
  const std::vector<double> w{1 / mass, 0, 0};
  Vec3 velocity;
  for (int step = 0; step < 30000; ++step) {
    const Vec3 before = x[0];
    velocity.y += force / mass * kLeashStep;
    velocity = velocity * 0.99;
    x[0] += velocity * kLeashStep;
    solve_leashes(std::span(&leash, 1), w, kLeashStep, x);
    velocity = (x[0] - before) * (1 / kLeashStep);
  }
  return x[0].y;
}

TEST(Leash, IsAsLongAsItsSpringAtRest) {
  Leash leash;
  leash.patch = {0};
  leash.share = {1};
  leash.stiffness = 150;
  leash.most_force = 5;
  EXPECT_NEAR(at_rest(0.01, 0.3, leash), 0.3 / 150, 0.02 * 0.3 / 150);
}

TEST(Leash, GivesWayToAStrongerForce) {
  Leash leash;
  leash.patch = {0};
  leash.share = {1};
  leash.stiffness = 2e4;
  leash.most_force = 5;
  EXPECT_LT(at_rest(0.01, 4.9, leash), 1e-3);
  EXPECT_GT(at_rest(0.01, 5.5, leash), 0.1);
}

TEST(Leash, SharesItsPullAmongItsPatchAndKeepsItsMomentum) {
  Leash leash;
  leash.patch = {0, 1, 2};
  leash.share = {0.5, 0.3, 0.2};
  leash.target = {0, 0, 1};
  leash.stiffness = 100;
  leash.most_force = 2;
  std::vector<Vec3> x{{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  const std::vector<double> w{100, 200, 400};
  solve_leashes(std::span(&leash, 1), w, kLeashStep, x);
  Vec3 impulse;
  for (std::size_t i = 0; i < 3; ++i)
    impulse += (x[i] - (i == 0 ? Vec3{-1, 0, 0} : Vec3{1, 0, 0})) * (1 / w[i]);
  EXPECT_NEAR(impulse.z, 2 * kLeashStep * kLeashStep, 1e-12);  // it would be 100 N: the limit holds
  EXPECT_NEAR(impulse.x, 0, 1e-12);
}

TEST(Leash, OfWhatIsHeldFastDoesNothing) {
  Leash leash;
  leash.patch = {0, 1, 2};
  leash.share = {0.5, 0.25, 0.25};
  leash.target = {0, 1, 0};
  leash.stiffness = 100;
  leash.most_force = 2;
  std::vector<Vec3> x(3);
  const std::vector<double> w{0, 0, 0};
  solve_leashes(std::span(&leash, 1), w, kLeashStep, x);
  for (const Vec3& p : x) EXPECT_EQ(p, Vec3{});
}

}  // namespace
}  // namespace toile
