#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/garments/hem_folds.h"

namespace toile::garments {
namespace {

/// A tube of 400 mm that widens by `flare` (m) downwards, broad and deep as said (m), with `waves` around it.
std::vector<Vec3> tube(double broad, double deep, double flare, int waves, double height_of_wave) {
  std::vector<Vec3> points;
  for (int ring = 0; ring <= 20; ++ring) {
    const double down = ring / 20.0;
    for (int k = 0; k < 300; ++k) {
      const double angle = 2 * std::numbers::pi * k / 300;
      const double r = 1 + flare * down + height_of_wave * down * std::cos(waves * angle);
      points.push_back({broad * r * std::cos(angle), -0.4 * down, deep * r * std::sin(angle)});
    }
  }
  return points;
}

TEST(HemFolds, ARoundTubeHasNone) { EXPECT_EQ(hem_folds(tube(0.2, 0.2, 0, 0, 0)), 0); }

TEST(HemFolds, AnEllipticTubeHasNoneThoughItsRadiusGoesUpAndDown) {
  EXPECT_EQ(hem_folds(tube(0.3, 0.15, 0.2, 0, 0)), 0);
  EXPECT_EQ(hem_folds(tube(0.15, 0.25, 0, 0, 0)), 0);
}

TEST(HemFolds, WavesAreCounted) {
  EXPECT_EQ(hem_folds(tube(0.2, 0.2, 0.2, 6, 0.15)), 6);
  EXPECT_EQ(hem_folds(tube(0.25, 0.18, 0.2, 8, 0.15)), 8);
}

TEST(HemFolds, RipplesThatOneHardlySeesAreNone) { EXPECT_EQ(hem_folds(tube(0.2, 0.2, 0, 8, 0.005)), 0); }

}  // namespace
}  // namespace toile::garments
