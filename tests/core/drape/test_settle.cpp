#include "core/drape/settle.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

constexpr double kStep = 1e-3;

constexpr double kDamping = 4;  // 1/s

/// Watches one particle whose position after each step is `at(step)`; says whether it ever settled in 1 s.
template <typename Motion>
bool settles(Motion at, double damping = kDamping) {
  drape::SettleWatch watch(kStep, 0.005);
  watch.restart(std::vector<Vec3>{at(0)});
  for (int i = 1; i <= 1000; ++i) {
    watch.observe(std::vector<Vec3>{at(i)}, damping);
    if (watch.settled(damping)) return true;
  }
  return false;
}

TEST(Settle, AParticleThatComesToRestSettles) {
  EXPECT_TRUE(settles([](int i) { return Vec3{0, std::exp(-0.02 * i), 0}; }));
}

TEST(Settle, WhatHardlyCreepsIsAtRestAndWhatSinksIsNot) {
  EXPECT_TRUE(settles([](int i) { return Vec3{0, -0.0014 * kStep * i, 0}; }));
  EXPECT_FALSE(settles([](int i) { return Vec3{0, -0.002 * kStep * i, 0}; }));
  EXPECT_FALSE(settles([](int i) { return Vec3{0, -0.02 * kStep * i, 0}; }));
}

TEST(Settle, WhatCreepsThroughAThickMediumGoesFarOnceItIsGone) {
  const auto creeps = [](int i) { return Vec3{0, -0.0014 * kStep * i, 0}; };
  EXPECT_TRUE(settles(creeps, 2));
  EXPECT_FALSE(settles(creeps, 16));
}

TEST(Settle, CalmerRestIsAShareOfIt) {
  drape::SettleWatch watch(kStep, 0.005);
  watch.restart(std::vector<Vec3>(1));
  for (int i = 1; i <= 400; ++i) watch.observe(std::vector<Vec3>{{0, 0.0014 * kStep * i, 0}}, kDamping);
  EXPECT_TRUE(watch.settled(kDamping));
  EXPECT_FALSE(watch.settled(kDamping, 0.2));
}

TEST(Settle, AParticleThatSpeedsUpHasNotSettledThoughItIsStillSlow) {
  // 1 mm/s at the start, doubling every 0.1 s: above the limit soon, and never steady before.
  EXPECT_FALSE(settles([](int i) { return Vec3{0, 0.001 / 6.93 * std::exp(6.93 * kStep * i), 0}; }));
}

TEST(Settle, WhatSwingsOnTheSpotIsNoDrift) {
  // 4 mm/s at most, five times a second.
  EXPECT_TRUE(settles([](int i) { return Vec3{1.2e-4 * std::sin(31.4 * kStep * i), 0, 0}; }));
}

TEST(Settle, AJitterOfSingleStepsDoesNotCount) {
  EXPECT_TRUE(settles([](int i) { return Vec3{i % 2 * 1e-4, 0, 0}; }));  // 0.1 m/s from step to step
}

/// A particle that shakes too fast to count as slow, and drifts at `drift` m/s: whether it settles in 3 s.
bool settles_shaking(double drift) {
  drape::SettleWatch watch(kStep, 0.005);
  const auto at = [&](int i) { return Vec3{2.2e-4 * std::sin(42 * kStep * i), drift * kStep * i, 0}; };
  watch.restart(std::vector<Vec3>{at(0)});
  for (int i = 1; i <= 3000; ++i) {
    watch.observe(std::vector<Vec3>{at(i)}, kDamping);
    if (!watch.settled(kDamping)) continue;
    EXPECT_GE(i, 2000);
    return true;
  }
  return false;
}

TEST(Settle, WhatFluttersInPlaceIsAtRestOnceItHasBeenNowhereElseForTwoSeconds) {
  EXPECT_TRUE(settles_shaking(0));
  EXPECT_FALSE(settles_shaking(0.0015)) << "and goes on its way";
}

TEST(Settle, TheDampingFollowsTheSwing) {
  const auto damping_for = [](double rate) {
    drape::SettleWatch watch(kStep, 0.005);
    watch.restart(std::vector<Vec3>{{1, 0, 0}});
    for (int i = 1; i <= 1000; ++i) watch.observe(std::vector<Vec3>{{std::cos(rate * kStep * i), 0, 0}}, 0);
    return watch.damping();
  };
  EXPECT_NEAR(damping_for(10), 2 * 0.3 * 10, 0.2);
  EXPECT_NEAR(damping_for(20), 2 * 0.3 * 20, 1);  // windows of 0.05 s see a swing of 0.3 s a little slow
  EXPECT_EQ(damping_for(1), 2);
  EXPECT_EQ(damping_for(40), 16);
}

TEST(Settle, LookingAnewForgetsTheShortWindowsAndNotTheLongOne) {
  drape::SettleWatch watch(kStep, 0.005);
  const std::vector<Vec3> x(1);
  watch.restart(x);
  for (int i = 0; i < 1900; ++i) watch.observe(x, kDamping);
  EXPECT_TRUE(watch.settled(kDamping));
  EXPECT_FALSE(watch.flutters_in_place());
  watch.look_anew(x);
  EXPECT_FALSE(watch.settled(kDamping));
  for (int i = 0; i < 200; ++i) watch.observe(x, kDamping);
  EXPECT_TRUE(watch.flutters_in_place()) << "two seconds since it began";
}

TEST(Settle, RestartForgets) {
  drape::SettleWatch watch(kStep, 0.005);
  const std::vector<Vec3> x(1);
  watch.restart(x);
  for (int i = 0; i < 300; ++i) watch.observe(x, kDamping);
  EXPECT_TRUE(watch.settled(kDamping));
  watch.restart(x);
  EXPECT_FALSE(watch.settled(kDamping));
}

}  // namespace
}  // namespace toile
