#include "core/geometry/distance.h"

#include <gtest/gtest.h>

#include <random>

namespace toile {
namespace {

Vec3 random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  return {u(random), u(random), u(random)};
}

TEST(Distance, NoSampledPointOfATriangleIsCloser) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random_point(random), a = random_point(random), b = random_point(random),
               c = random_point(random);
    const geometry::TrianglePoint at = geometry::closest_on_triangle(p, a, b, c);
    EXPECT_NEAR(at.a + at.b + at.c, 1, 1e-12);
    EXPECT_TRUE(at.a >= 0 && at.b >= 0 && at.c >= 0);
    const double best = length(p - (a * at.a + b * at.b + c * at.c));
    for (int u = 0; u <= 20; ++u) {
      for (int v = 0; u + v <= 20; ++v) {
        EXPECT_GE(length(p - (a * (u / 20.0) + b * (v / 20.0) + c * (1 - (u + v) / 20.0))), best - 1e-12);
      }
    }
  }
}

TEST(Distance, NoSampledPairOfPointsOfTwoEdgesIsCloser) {
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p0 = random_point(random), p1 = random_point(random), q0 = random_point(random);
    const Vec3 q1 = i % 5 == 0 ? q0 + (p1 - p0) * 0.7 : random_point(random);  // every fifth pair parallel
    const geometry::EdgePoints at = geometry::closest_on_edges(p0, p1, q0, q1);
    const double best = length(p0 + (p1 - p0) * at.s - q0 - (q1 - q0) * at.t);
    for (int u = 0; u <= 20; ++u) {
      for (int v = 0; v <= 20; ++v) {
        EXPECT_GE(length(p0 + (p1 - p0) * (u / 20.0) - q0 - (q1 - q0) * (v / 20.0)), best - 1e-9);
      }
    }
  }
}

TEST(Distance, DegenerateShapesGiveFinitePoints) {
  const Vec3 a{1, 2, 3};
  const geometry::TrianglePoint t = geometry::closest_on_triangle({0, 0, 0}, a, a, a);
  EXPECT_NEAR(t.a + t.b + t.c, 1, 1e-12);
  const geometry::EdgePoints e = geometry::closest_on_edges(a, a, {0, 0, 0}, {1, 0, 0});
  EXPECT_EQ(e.t, 1);
}

}  // namespace
}  // namespace toile
