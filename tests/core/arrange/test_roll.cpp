// Pieces that are sewn to themselves, rolled up.

#include "core/arrange/roll.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The sides of a sector about (0.3, 0.2) that spreads to both sides of -y, 0.2 to 0.8 m from its apex.
std::vector<std::array<Vec2, 2>> sides_of_sector(double degrees) {
  const Vec2 apex{0.3, 0.2};
  const double half = degrees / 2 * kDegree;
  std::vector<std::array<Vec2, 2>> sides;
  for (int k = 0; k <= 6; ++k) {
    const double r = 0.8 - 0.1 * k;  // from its hem up
    sides.push_back({apex + Vec2{-std::sin(half), -std::cos(half)} * r,
                     apex + Vec2{std::sin(half), -std::cos(half)} * r});
  }
  return sides;
}

TEST(Roll, ASectorIsAConeOfItsAngle) {
  for (const double degrees : {20.0, 90.0, 180.0, 270.0, 340.0}) {
    const Vec2 centroid{0.3, 0.2 - 0.5 * std::sin(degrees / 2 * kDegree) / (degrees / 2 * kDegree)};
    const auto roll = arrange::roll_of(sides_of_sector(degrees), centroid, {1, 0});
    ASSERT_TRUE(roll) << degrees;
    EXPECT_NEAR(roll->slope, degrees / 360, 1e-6) << degrees;
    EXPECT_NEAR(roll->above, 0.2 * degrees * kDegree, 1e-6) << degrees;
    EXPECT_NEAR(roll->below, 0.8 * degrees * kDegree, 1e-6) << degrees;
    EXPECT_NEAR(roll->length, 0.6, 1e-9) << degrees;
    EXPECT_NEAR(length(roll->top - Vec2{0.3, 0}), 0, 1e-6) << degrees;
    EXPECT_NEAR(length(roll->up - Vec2{0, 1}), 0, 1e-6) << degrees;
  }
}

TEST(Roll, AStraightTubeStandsAlongItsGrain) {
  const std::vector<std::array<Vec2, 2>> sides{{Vec2{0, 0}, Vec2{0.7, 0}}, {Vec2{0, 0.5}, Vec2{0.7, 0.5}}};
  for (const double up : {-1.0, 1.0}) {
    const auto roll = arrange::roll_of(sides, {0.35, 0.25}, {0, up});
    ASSERT_TRUE(roll);
    EXPECT_NEAR(roll->up.y, up, 1e-9);
    EXPECT_NEAR(roll->top.y, up > 0 ? 0.5 : 0, 1e-9);
    EXPECT_EQ(roll->slope, 0);
    EXPECT_NEAR(roll->above, 0.7, 1e-9);
  }
}

TEST(Roll, ASeamWithoutLengthRollsNothing) {
  EXPECT_FALSE(arrange::roll_of({}, {}, {0, 1}));
  EXPECT_FALSE(arrange::roll_of({{Vec2{0, 0}, Vec2{1, 0}}, {Vec2{0, 0}, Vec2{1, 0}}}, {}, {0, 1}));
}

}  // namespace
}  // namespace toile
