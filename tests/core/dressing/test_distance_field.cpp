#include "core/dressing/distance_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

/// A ball of `rings` rings, with a hole at the pole when `open`.
geometry::TriangleMesh ball(double radius, bool open = false, int rings = 40) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= rings; ++i) {
    const double a = std::numbers::pi * i / rings;
    for (int j = 0; j < rings; ++j) {
      const double b = 2 * std::numbers::pi * j / rings;
      mesh.vertices.push_back(Vec3{std::sin(a) * std::sin(b), std::cos(a), std::sin(a) * std::cos(b)} *
                              radius);
    }
  }
  for (Index i = open ? 2 : 0; i < rings; ++i) {
    for (Index j = 0; j < rings; ++j) {
      const Index a = i * rings + j, b = i * rings + (j + 1) % rings;
      mesh.triangles.push_back({a, a + rings, b});
      mesh.triangles.push_back({b, a + rings, b + rings});
    }
  }
  return mesh;
}

TEST(DistanceField, OfABallIsTheWayToItsSkin) {
  const dressing::DistanceField field(ball(0.1), 0.01);
  EXPECT_NEAR(field.distance({0, 0, 0}), -0.1, 0.012) << "between cells a peak is flattened by one at most";
  EXPECT_NEAR(field.distance({0.06, 0, 0}), -0.04, 0.003);
  EXPECT_NEAR(field.distance({0, 0.12, 0}), 0.02, 0.003);
  EXPECT_NEAR(field.distance({0, 0, 0.5}), 0.4, 0.02) << "beyond the grid";
}

TEST(DistanceField, AHoleInTheMeshDoesNotTurnItInsideOut) {
  const dressing::DistanceField field(ball(0.1, true), 0.01);
  EXPECT_LT(field.distance({0, 0, 0}), -0.08);
  EXPECT_LT(field.distance({0.05, 0.03, 0}), 0);
  EXPECT_GT(field.distance({0, 0.13, 0}), 0);
}

TEST(DistanceField, ThicknessIsTheLargestBallsAndTheSlimFigureIsDrawnInByItsShare) {
  const dressing::DistanceField field(ball(0.1), 0.01);
  EXPECT_NEAR(field.half_thickness({0.08, 0, 0}), 0.1, 0.012) << "near the skin as in the middle";
  EXPECT_NEAR(field.distance({0.05, 0, 0}, 0.5), 0, 0.008) << "half way in is the slim figure's skin";
  const Vec3 out = field.outwards({0.07, 0, 0}, 0.5);
  EXPECT_GT(out.x, 0.95);
}

TEST(DistanceField, LimbsStayAsThinAsTheyAre) {
  const dressing::Person& person = test::person();
  const dressing::DistanceField field(person.body->mesh, 0.01);
  const double arm = field.half_thickness(person.figure.arm[0].elbow);
  const double trunk = field.half_thickness({person.figure.middle, person.figure.waist, 0});
  EXPECT_GT(arm, 0.015);
  EXPECT_LT(arm, 0.06);
  EXPECT_GT(trunk, 1.5 * arm);
}

}  // namespace
}  // namespace toile
