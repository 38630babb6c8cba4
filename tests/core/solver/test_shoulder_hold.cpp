// What keeps cloth on a shoulder.

#include "core/solver/constraints/shoulder_hold.h"

#include <gtest/gtest.h>

#include <vector>

namespace toile {
namespace {

using solver::constraints::BroughtBack;
using solver::constraints::ShoulderHold;

/// The left shoulder of somebody whose middle is at x = 0.1: it runs 10 cm out and falls by 4 cm.
ShoulderHold hold_of(std::vector<ShoulderHold::Held> held) {
  return {0.1, {0.16, 1.5, 0}, {0.1, -0.04, 0}, 0, 1.4, 0.06, 0.03, 0.3, std::move(held)};
}

/// After a pass on cloth that was still.
std::vector<Vec3> passed(const ShoulderHold& hold, std::vector<Vec3> x, double h, double w = 1) {
  const std::vector<double> mobile(x.size(), w);
  const std::vector<Vec3> before = x;
  std::vector<BroughtBack> none;
  solver::constraints::solve_shoulder_holds(std::vector<ShoulderHold>{hold}, mobile, h, before, x, none);
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
  const std::vector<double> mobile(2, 1);
  const std::vector<Vec3> before{{0.22, 1.49, 0}, {0.23, 1.48, 0}};
  std::vector<Vec3> x{{0.225, 1.49, 0}, {0.24, 1.48, 0}};
  std::vector<BroughtBack> brought;
  solver::constraints::solve_shoulder_holds(std::vector<ShoulderHold>{hold_of({{0, 0.12}, {1, 0.12}})},
                                            mobile, 1e-3, before, x, brought);
  EXPECT_DOUBLE_EQ(x[0].x, 0.22) << "5 m/s outwards";
  EXPECT_DOUBLE_EQ(x[1].x, 0.23 - 1e-3 * solver::constraints::kHandSpeed);
  ASSERT_EQ(brought.size(), 1U) << "to stop is not to bring";
  EXPECT_EQ(brought[0].v, 1);
  EXPECT_NEAR(brought[0].dx, -1e-3 * solver::constraints::kHandSpeed, 1e-15);
}

TEST(ShoulderHold, LaysBackAndDoesNotThrow) {
  const std::vector<BroughtBack> brought{{0, -3e-3}, {1, -3e-3}, {2, 3e-3}, {3, -3e-3}};
  // Went all the way and fell; was stopped half way by contact; the other shoulder's, drawn farther by cloth;
  // pulled outwards all the same.
  std::vector<Vec3> v{{-3, -1, 0}, {-1.5, 0, 0}, {5, 0, 2}, {0.5, 0, 0}};
  solver::constraints::let_lie(brought, 1e-3, v);
  EXPECT_EQ(v, (std::vector<Vec3>{{0, -1, 0}, {0, 0, 0}, {2, 0, 2}, {0.5, 0, 0}}));
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
