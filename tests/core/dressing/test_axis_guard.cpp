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

/// The gap between two edges that are 20 cm apart: an axis may not come out there.
TEST(AxisGuard, AGapIsNotDrawnOverALimb) {
  Scene s;
  s.x = {{0.02, 0, -0.1}, {0.3, 0, -0.1}, {0.02, 0, 0.1}, {0.3, 0, 0.1}};
  const std::vector<Tri> gap{{0, 1, 2}, {2, 3, 1}};
  std::vector<Vec3> moved = s.x;
  for (Vec3& p : moved) p.x -= 0.05;
  const std::vector<Vec3> wanted = moved;
  dressing::AxisGuard unguarded(s.axes, {}, s.x);
  unguarded.keep(s.x, moved);
  EXPECT_EQ(moved, wanted);
  dressing::AxisGuard guard(s.axes, {}, s.x, {s.axes, gap});
  guard.keep(s.x, moved);
  for (const std::size_t v : {0, 1, 2})
    EXPECT_EQ(moved[v], s.x[v]) << "of the half that the axis went through";
}

/// A row of triangles that leaps over a row of axes, one that is caught by the first: each that goes back
/// would be torn out long across the next axis.
TEST(AxisGuard, WhatGoesBackTakesItsNeighboursAlong) {
  Scene s;
  constexpr Index kRow = 14;
  s.x.clear();
  s.triangles.clear();
  s.axes.clear();
  for (Index k = 0; k <= kRow; ++k) {
    const double z = 0.05 * k;
    s.x.push_back({k % 2 == 0 ? 0.02 : 0.12, 0, z});
    s.axes.push_back({Vec3{0, -1, z + 0.02}, Vec3{0, 1, z + 0.02}});
    if (k >= 2) s.triangles.push_back({k - 2, k - 1, k});
  }
  dressing::AxisGuard guard(s.axes, s.triangles, s.x);
  std::vector<Vec3> moved = s.x;
  for (Vec3& p : moved) p.x -= 1;
  moved.front().x = -0.03;
  moved[1].x = 0.07;
  guard.keep(s.x, moved);
  EXPECT_EQ(moved, s.x);
}

/// The rectangle of a sleeve around an arm and a bodice's two pieces: the sleeve's seam alone is guarded.
TEST(AxisGuard, GapsAreThoseOfWhatIsForALimb) {
  sewing::GarmentMesh g;
  g.rest.resize(12);
  g.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}, {5, 7, 6}, {8, 9, 10}, {9, 11, 10}};
  g.panel_of_vertex = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2};
  g.sewn = {{0, 2}, {1, 3}, {4, 8}, {5, 9}};
  g.seam_of_sewn = {0, 0, 1, 1};
  const dressing::Skeleton skeleton = dressing::skeleton_of(test::person().figure);
  using enum dressing::Covers;
  const std::vector<dressing::Covers> covers{kArm, kTrunk, kTrunk};
  const dressing::Gaps gaps = dressing::gaps_of(g, covers, skeleton);
  EXPECT_EQ(gaps.triangles, (std::vector<Tri>{{0, 1, 2}, {2, 3, 1}}));
  EXPECT_EQ(gaps.axes.size(), 14U) << "four of each arm, three of each leg";
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
