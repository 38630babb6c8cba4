// What keeps cloth on a shoulder.

#include "core/solver/constraints/shoulder_hold.h"

#include <gtest/gtest.h>

#include <vector>

namespace toile {
namespace {

using solver::constraints::ShoulderHold;

/// The left shoulder of somebody whose middle is at x = 0.1: it runs 10 cm out and falls by 4 cm.
ShoulderHold hold_of(std::vector<ShoulderHold::Held> held) {
  return {0.1, {0.16, 1.5, 0}, {0.1, -0.04, 0}, 0, 1.4, 0.06, 0.03, 0.3, std::move(held)};
}

/// After a pass on cloth that was still.
std::vector<Vec3> passed(const ShoulderHold& hold, std::vector<Vec3> x, double h, double w = 1) {
  const std::vector<double> mobile(x.size(), w);
  const std::vector<Vec3> before = x;
  solver::constraints::solve_shoulder_holds(std::vector<ShoulderHold>{hold}, mobile, h, before, x);
  return x;
}

TEST(ShoulderHold, BringsBackWhatSlidOutAndNothingElse) {
  const ShoulderHold hold = hold_of({{0, 0.12}, {1, 0.12}});
  const std::vector<Vec3> x = passed(hold, {{0.22002, 1.49, 0}, {0.215, 1.49, 0}}, 1e-3);
  EXPECT_DOUBLE_EQ(x[0].x, 0.22) << "12 cm from the middle";
  EXPECT_EQ(x[0].y, 1.49);
  EXPECT_EQ(x[1], (Vec3{0.215, 1.49, 0})) << "farther in it is free";
}

TEST(ShoulderHold, TakesItsTime) {
  const std::vector<Vec3> x = passed(hold_of({{0, 0.12}}), {{0.25, 1.48, 0}}, 1e-3);
  EXPECT_DOUBLE_EQ(x[0].x, 0.25 - 1e-3 * solver::constraints::kHandSpeed);
}

TEST(ShoulderHold, StopsWhatSlidesHoweverHardItIsPulled) {
  const ShoulderHold hold = hold_of({{0, 0.12}, {1, 0.12}});
  const std::vector<double> mobile(2, 1);
  const std::vector<Vec3> before{{0.22, 1.49, 0}, {0.23, 1.48, 0}};
  std::vector<Vec3> x{{0.225, 1.49, 0}, {0.24, 1.48, 0}};
  solver::constraints::solve_shoulder_holds(std::vector<ShoulderHold>{hold}, mobile, 1e-3, before, x);
  EXPECT_DOUBLE_EQ(x[0].x, 0.22) << "5 m/s outwards";
  EXPECT_DOUBLE_EQ(x[1].x, 0.23 - 1e-3 * solver::constraints::kHandSpeed);
}

TEST(ShoulderHold, ComesAndGoesWithoutStirring) {
  // A neckline that comes and goes lets the hand hold each second step: the strap, drawn out by a spring,
  // must never be thrown back faster than the hand moves.
  const ShoulderHold hold = hold_of({{0, 0.12}, {1, 0.12}});
  const std::vector<double> mobile(2, 1);
  constexpr double kStep = 1e-3, kPull = 40;  // s, m/s²
  std::vector<Vec3> x{{0.221, 1.49, 0}, {0.18, 1.5, 0}};
  double v = 0, back = 0;
  for (int step = 0; step < 2000; ++step) {
    x[1].x = step % 2 == 0 ? 0.18 : 0.22;
    const std::vector<Vec3> before = x;
    v += kPull * kStep;
    x[0].x += v * kStep;
    solver::constraints::solve_shoulder_holds(std::vector<ShoulderHold>{hold}, mobile, kStep, before, x);
    v = (x[0].x - before[0].x) / kStep;
    back = std::min(back, v);
  }
  EXPECT_GE(back, -1.001 * solver::constraints::kHandSpeed);
}

TEST(ShoulderHold, LetsGoOfWhatIsNotOverTheShoulder) {
  const ShoulderHold hold = hold_of({{0, 0.12}});
  for (const Vec3 p : {Vec3{0.31, 1.45, 0}, Vec3{0.24, 1.4, 0}, Vec3{0.24, 1.49, 0.08}, Vec3{-0.05, 1.49, 0}})
    EXPECT_EQ(passed(hold, {p}, 1e-3)[0], p) << p.x << " " << p.y << " " << p.z;
}

TEST(ShoulderHold, IsNotNeededWhereClothIsAtTheNeck) {
  const ShoulderHold hold = hold_of({{0, 0.12}, {1, 0.12}});
  const Vec3 strap{0.221, 1.49, 0}, neckline{0.18, 1.5, 0};
  EXPECT_EQ(passed(hold, {strap, neckline}, 1e-3)[0], strap);
  EXPECT_FALSE(solver::constraints::bears(hold, std::vector<Vec3>{strap, neckline}));
}

TEST(ShoulderHold, MovesNoPinnedVertex) {
  EXPECT_EQ(passed(hold_of({{0, 0.12}}), {{0.23, 1.49, 0}}, 1e-3, 0)[0].x, 0.23);
}

TEST(ShoulderHold, BearsWhatLeansOnIt) {
  const ShoulderHold hold = hold_of({{0, 0.12}});
  EXPECT_TRUE(solver::constraints::bears(hold, std::vector<Vec3>{{0.22, 1.49, 0}}));
  EXPECT_FALSE(solver::constraints::bears(hold, std::vector<Vec3>{{0.21, 1.49, 0}}));
  EXPECT_FALSE(solver::constraints::bears(hold, std::vector<Vec3>{{0.22, 1.3, 0}})) << "it has slid off";
}

}  // namespace
}  // namespace toile
