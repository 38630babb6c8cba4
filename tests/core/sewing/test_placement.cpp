#include "core/sewing/placement.h"

#include <gtest/gtest.h>

#include "core/base/units.h"

namespace toile {
namespace {

/// A grid of flat points, and the lengths between neighbours in the plane and in space.
std::vector<Vec2> flat_grid() {
  std::vector<Vec2> points;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) points.push_back({-0.2 + 0.02 * i, -0.3 + 0.02 * j});
  }
  return points;
}

/// Greatest relative change of a neighbour distance, over steps small enough to be nearly straight.
double stretch(const sewing::WrappedPlacement& wrapped) {
  double most = 0;
  constexpr double kStep = 1e-4;
  for (const Vec2& p : flat_grid()) {
    for (const Vec2 d : {Vec2{kStep, 0}, Vec2{0, kStep}, Vec2{kStep, kStep}}) {
      const std::vector<Vec3> x = sewing::place({p, p + d}, wrapped);
      most = std::max(most, std::abs(length(x[1] - x[0]) / length(d) - 1));
    }
  }
  return most;
}

TEST(Placement, ARigidPlacementTurnsAboutXThenYThenZ) {
  sewing::RigidPlacement rigid;
  rigid.translation = {1, 2, 3};
  rigid.rotation = {kPi / 2, 0, kPi / 2};  // (0, 1, 0) → (0, 0, 1) → the same
  const std::vector<Vec3> x = sewing::place({{0, 1}, {1, 0}}, rigid);
  EXPECT_NEAR(length(x[0] - Vec3{1, 2, 4}), 0, 1e-12);
  EXPECT_NEAR(length(x[1] - Vec3{1, 3, 3}), 0, 1e-12);
}

TEST(Placement, AFlippedPieceIsMirrored) {
  sewing::RigidPlacement rigid;
  rigid.flipped = true;
  EXPECT_EQ(sewing::place({{0.5, 0.25}}, rigid)[0], (Vec3{-0.5, 0.25, 0}));
}

TEST(Placement, WrappingAroundACylinderDoesNotStretch) {
  sewing::WrappedPlacement w;
  w.radius = 0.2;
  EXPECT_LT(stretch(w), 1e-6);
}

TEST(Placement, WrappingAroundAConeDoesNotStretchWhicheverWayItOpens) {
  for (const double slope : {0.3, -0.3, 0.8}) {
    sewing::WrappedPlacement w;
    w.radius = 0.5;
    w.slope = slope;
    w.angle = 1;
    EXPECT_LT(stretch(w), 1e-5) << "slope " << slope;
  }
}

TEST(Placement, AConeWidensDownwardsAndTurnsTheRightWay) {
  sewing::WrappedPlacement w;
  w.axis = {0.1, 0, -0.1};
  w.radius = 0.3;
  w.slope = 0.25;
  w.height = 1;
  w.anchor = {0.05, 0};
  const std::vector<Vec3> x = sewing::place({{0.05, 0}, {0.05, -0.4}, {0.15, 0}}, w);
  EXPECT_NEAR(length(x[0] - Vec3{0.1, 1, 0.2}), 0, 1e-12) << "the anchor stands in front at its height";
  EXPECT_NEAR(x[1].z + 0.1, 0.3 + 0.25 * 0.4, 1e-12);
  EXPECT_LT(x[1].y, x[0].y);
  EXPECT_GT(x[2].x, x[0].x) << "u runs towards +x in front";
}

TEST(Placement, ANearlyUprightConeIsTheCylinder) {
  sewing::WrappedPlacement cylinder, cone;
  cone.slope = 1e-6;
  const std::vector<Vec3> a = sewing::place(flat_grid(), cylinder), b = sewing::place(flat_grid(), cone);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(length(a[i] - b[i]), 0, 1e-5);
}

TEST(Placement, AroundATiltedAxisNothingStretchesAndTheDistanceStays) {
  sewing::WrappedPlacement w;
  w.axis = {0.2, 1.3, 0};
  w.up = normalized(Vec3{-0.7, 0.7, 0.1});
  w.radius = 0.08;
  w.height = -0.1;
  w.turn = 0.7;
  w.angle = 1.5;
  EXPECT_LT(stretch(w), 1e-5);
  for (const Vec3& p : sewing::place(flat_grid(), w)) {
    EXPECT_NEAR(length(cross(p - w.axis, w.up)), w.radius, 1e-12);
  }
  EXPECT_NEAR(dot(sewing::place({w.anchor}, w)[0] - w.axis, w.up), w.height, 1e-12);
}

TEST(Placement, AFlippedRollShowsItsOtherSide) {
  sewing::WrappedPlacement w;
  w.radius = 0.2;
  const auto normal = [&] {
    const std::vector<Vec3> p = sewing::place({{0, 0}, {0.001, 0}, {0, 0.001}}, w);
    return cross(p[1] - p[0], p[2] - p[0]);
  };
  EXPECT_GT(normal().z, 0) << "outwards, in front";
  w.flipped = true;
  EXPECT_LT(normal().z, 0);
}

}  // namespace
}  // namespace toile
