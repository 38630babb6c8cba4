#include "core/drape/rayleigh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace toile {
namespace {

constexpr double kSeconds = 0.01;

/// Ways of three windows of a motion x(t), from `start` (s) on; each coordinate on its own.
template <typename Motion>
double rate_of(Motion x, double damping, double start = 0) {
  std::vector<float> ways[3];
  for (int k = 0; k < 3; ++k) {
    const double t = start + k * kSeconds;
    for (int c = 0; c < 3; ++c) ways[k].push_back(static_cast<float>(x(t + kSeconds, c) - x(t, c)));
  }
  return drape::rayleigh_rate(ways[0], ways[1], ways[2], kSeconds, damping);
}

TEST(RayleighRate, IsThatOfAnUndampedSwingWhereverItIs) {
  for (const double start : {0.0, 0.1, 0.3}) {
    EXPECT_NEAR(rate_of([](double t, int) { return std::cos(6 * t); }, 0, start), 6, 0.05);
  }
}

TEST(RayleighRate, IsThatOfADampedSwing) {
  // ẍ + c ẋ + ω² x = 0 with c = 4, ω = 7: x = e^(−2t) cos(√(49 − 4) t).
  const auto x = [](double t, int) { return std::exp(-2 * t) * std::cos(std::sqrt(45.0) * t); };
  EXPECT_NEAR(rate_of(x, 4), 7, 0.1);
}

TEST(RayleighRate, IsThatOfACreepBackThroughAThickMedium) {
  // c = 30, ω = 5: it creeps as e^(−λt), λ² − 30 λ + 25 = 0.
  const double lambda = 15 - std::sqrt(200.0);
  EXPECT_NEAR(rate_of([&](double t, int) { return std::exp(-lambda * t); }, 30), 5, 0.1);
}

TEST(RayleighRate, IsNothingForWhatIsNotDrawnBack) {
  EXPECT_EQ(rate_of([](double, int) { return 1.0; }, 4), 0);                // rests
  EXPECT_LT(rate_of([](double t, int) { return 2 * t; }, 4), 0.1);          // goes evenly
  EXPECT_LT(rate_of([](double t, int) { return 4.905 * t * t; }, 0), 0.1);  // falls
  EXPECT_EQ(rate_of([](double t, int) { return std::exp(5 * t); }, 2), 0);  // tips over
  EXPECT_EQ(drape::rayleigh_rate({}, {}, {}, kSeconds, 2), 0);
}

TEST(RayleighRate, WeighsSwingsBySizeOfMotion) {
  const auto both = [](double t, int c) { return c == 0 ? std::cos(4 * t) : 0.001 * std::cos(40 * t); };
  EXPECT_NEAR(rate_of(both, 0, 0.2), 4, 0.2);
}

TEST(CalmingDamping, GrowsWithTheRateWithinLimits) {
  EXPECT_EQ(drape::calming_damping(0), 2);
  EXPECT_DOUBLE_EQ(drape::calming_damping(10), 6);
  EXPECT_EQ(drape::calming_damping(1000), 16);
}

TEST(WayLeft, IsAmplitudeForASwingAndTheRestOfTheWayForACreep) {
  EXPECT_NEAR(drape::way_left(0.1, 0, 10), 0.01, 1e-12);              // v/ω
  EXPECT_NEAR(drape::way_left(0.1, 1000, 10), 1, 0.02);               // v c/ω²
  EXPECT_EQ(drape::way_left(0.1, 2, 0), drape::way_left(0.1, 2, 5));  // nothing is taken to be slower
}

}  // namespace
}  // namespace toile
