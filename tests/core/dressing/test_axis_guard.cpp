#include "core/dressing/axis_guard.h"

#include <gtest/gtest.h>

#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

/// An upright axis, and a triangle beside it at x = 2 cm.
struct Scene {
  std::vector<std::array<Vec3, 2>> axes{{Vec3{0, -1, 0}, Vec3{0, 1, 0}}};
  std::vector<Tri> triangles{{0, 1, 2}};
  std::vector<Vec3> x{{0.02, 0, -0.1}, {0.02, 0, 0.1}, {0.3, 0, 0}};
};

TEST(AxisGuard, ATriangleThatPassesOntoAnAxisGoesBack) {
  Scene s;
  dressing::AxisGuard guard(s.axes, s.triangles, s.x);
  std::vector<Vec3> moved = s.x;
  for (Vec3& p : moved) p.x -= 0.05;
  guard.keep(s.x, moved);
  EXPECT_EQ(moved, s.x);
}

TEST(AxisGuard, WhatStaysBesideItIsFree) {
  Scene s;
  dressing::AxisGuard guard(s.axes, s.triangles, s.x);
  std::vector<Vec3> moved = s.x;
  for (Vec3& p : moved) p += Vec3{-0.01, 0.2, 0.1};
  const std::vector<Vec3> wanted = moved;
  guard.keep(s.x, moved);
  EXPECT_EQ(moved, wanted);
}

TEST(AxisGuard, WhatAnAxisWentThroughFromTheStartMaySlideOff) {
  Scene s;
  for (Vec3& p : s.x) p.x -= 0.05;
  dressing::AxisGuard guard(s.axes, s.triangles, s.x);
  std::vector<Vec3> moved = s.x;
  for (Vec3& p : moved) p.x += 0.01;
  const std::vector<Vec3> wanted = moved;
  guard.keep(s.x, moved);
  EXPECT_EQ(moved, wanted);
}

TEST(AxisGuard, AxesLieWithinTheBodyButForAHandsBreadth) {
  const dressing::Person& person = test::person();
  const auto axes = dressing::axes_of(dressing::skeleton_of(person.figure));
  EXPECT_GE(axes.size(), 15U);
  for (const auto& [from, to] : axes) {
    for (const Vec3 p : {from, to}) {
      EXPECT_GE(p.y, person.figure.floor - 1e-9);
      EXPECT_LE(p.y, person.figure.top);
    }
  }
}

}  // namespace
}  // namespace toile
