#include "core/material/ellipse.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

const double kQuarter = std::acos(0.0);

TEST(Elliptical, IsWarpAlongTheWarpAndWeftAcrossIt) {
  EXPECT_DOUBLE_EQ(material::elliptical(0.8, 0.2, 0), 0.8);
  EXPECT_DOUBLE_EQ(material::elliptical(0.8, 0.2, 2 * kQuarter), 0.8);
  EXPECT_NEAR(material::elliptical(0.8, 0.2, kQuarter), 0.2, 1e-15);
}

TEST(Elliptical, LiesOnTheEllipseBetweenThem) {
  const double a = 0.7, b = 0.3;
  for (double angle = 0; angle < 7; angle += 0.1) {
    const double r = material::elliptical(a, b, angle);
    EXPECT_NEAR(std::pow(r * std::cos(angle) / a, 2) + std::pow(r * std::sin(angle) / b, 2), 1, 1e-12);
    EXPECT_DOUBLE_EQ(material::elliptical(b, b, angle), b) << "a circle is the same everywhere";
  }
}

TEST(Elliptical, OfNothingIsNothing) {
  EXPECT_EQ(material::elliptical(0, 0, 0.3), 0);
  EXPECT_EQ(material::elliptical(0.5, 0, 0.3), 0);
  EXPECT_EQ(material::elliptical(0, 0.5, 0), 0);
}

}  // namespace
}  // namespace toile
