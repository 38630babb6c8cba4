#include "core/dressing/untangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/dressing/clearance.h"
#include "core/dressing/wearer.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

constexpr double kSpacing = 0.02;  // m

/// A square sheet of n × n squares of kSpacing, from `corner` along u and v; appended.
void add_sheet(Index n, Vec3 corner, Vec3 u, Vec3 v, std::vector<Vec3>& x, std::vector<Tri>& triangles) {
  const auto first = static_cast<Index>(x.size());
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) x.push_back(corner + u * (kSpacing * i) + v * (kSpacing * j));
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index a = first + i * (n + 1) + j, b = a + n + 1;
      triangles.push_back({a, b, a + 1});
      triangles.push_back({b, b + 1, a + 1});
    }
  }
}

const dressing::Wearer& wearer() {
  static const dressing::Wearer wearer(test::person());
  return wearer;
}

TEST(Untangle, ASheetThatPokesThroughAnotherIsDrawnBack) {
  std::vector<Vec3> x;
  std::vector<Tri> triangles;
  add_sheet(10, {2, 1, 0}, {1, 0, 0}, {0, 1, 0}, x, triangles);
  add_sheet(6, {2.043, 1.047, -0.105}, {1, 0, 0.001}, {0.001, 0, 1}, x,
            triangles);  // its edge sticks out by 15 mm
  const auto surface = collision::make_surface(triangles, static_cast<Index>(x.size()));
  ASSERT_FALSE(collision::self_crossings(surface, x).empty());
  const auto left = dressing::untangle(surface, wearer().slim(0), wearer().crossing(), kSpacing, 100, x).left;
  EXPECT_TRUE(left.none()) << left.cloth_cloth;
  EXPECT_TRUE(collision::self_crossings(surface, x).empty());
}

/// A strap of two triangles over the left shoulder, whose ends lie before and behind it and whose middle is
/// 15 mm under its ridge.
struct SunkStrap {
  std::vector<Vec3> x;
  std::vector<Tri> triangles{{0, 1, 2}, {2, 1, 3}};
  double ridge = 0;

  SunkStrap() {
    const measure::BodyFigure& f = test::person().figure;
    const double at = (f.neck_side[0].x + f.shoulder[0].x) / 2;
    const auto bare = [&](Vec3 p) { return wearer().slim(0).field->distance(p) > 5e-3; };
    double middle = 0, most = 0;
    for (double z = -0.1; z < 0.1; z += 5e-3) {  // where the shoulder is highest
      Vec3 p{at, f.chin + 0.1, z};
      while (!bare(p)) p.x += 1e-3;
      while (bare(p)) p.y -= 1e-3;
      if (p.y <= most) continue;
      most = p.y;
      middle = z;
    }
    ridge = most;
    for (const double side : {1.0, -1.0}) {
      for (const double aside : {0.0, 0.015}) {
        Vec3 end{at + aside, ridge - 0.02, middle};
        while (!bare(end)) end.z += 1e-3 * side;
        x.push_back(end);
      }
    }
  }
};

TEST(Untangle, AStrapThatSpansAShoulderUnderItsRidgeIsLiftedOverIt) {
  SunkStrap strap;
  const auto surface = collision::make_surface(strap.triangles, 4);
  ASSERT_FALSE(collision::body_crossings(surface, strap.x, wearer().crossing()).empty());
  dressing::AxisGuard guard(dressing::axes_of(wearer().skeleton()), strap.triangles, strap.x);
  const auto left =
      dressing::untangle(surface, wearer().slim(0), wearer().crossing(), 0.03, 100, strap.x, &guard).left;
  EXPECT_TRUE(left.none()) << left.cloth_body;
  const Vec3 middle = (strap.x[0] + strap.x[1] + strap.x[2] + strap.x[3]) * 0.25;
  EXPECT_GT(wearer().slim(0).field->distance(middle), 0);
  EXPECT_GT(middle.y, strap.ridge - 0.012) << "over the shoulder, not off it";
}

TEST(Untangle, ClothInTheSkinComesOut) {
  const measure::BodyFigure& f = test::person().figure;
  std::vector<Vec3> x;
  std::vector<Tri> triangles;
  Vec3 skin{f.middle - 0.06, f.waist + 0.05, 0};
  while (wearer().slim(0).clearance(skin) < 0) skin.z += 1e-3;
  add_sheet(6, skin - Vec3{0, 0, 0.02}, {1, 0, 0}, {0, 0.95, 0.31}, x, triangles);  // leans out
  const auto surface = collision::make_surface(triangles, static_cast<Index>(x.size()));
  ASSERT_FALSE(collision::body_crossings(surface, x, wearer().crossing()).empty());
  const auto left = dressing::untangle(surface, wearer().slim(0), wearer().crossing(), kSpacing, 100, x).left;
  EXPECT_TRUE(left.none()) << left.cloth_body;
}

TEST(Clearance, SheetsThatNearlyTouchAreMovedToWhereContactCanBegin) {
  std::vector<Vec3> x;
  std::vector<Tri> triangles;
  add_sheet(6, {2, 1, 0}, {1, 0, 0}, {0, 1, 0}, x, triangles);
  add_sheet(6, {2.003, 1.004, 3e-6}, {1, 0, 0}, {0, 1, 0}, x, triangles);
  const auto surface = collision::make_surface(triangles, static_cast<Index>(x.size()));
  ASSERT_LT(dressing::least_gap(surface, {}, x), dressing::kLeastGap);
  EXPECT_GE(dressing::open_gaps(surface, {}, x), dressing::kLeastGap);
  EXPECT_TRUE(collision::self_crossings(surface, x).empty());
  for (const Vec3& p : x) EXPECT_LT(std::abs(p.z), 1e-3) << "and hardly farther";
}

TEST(Untangle, WhatCrossesNothingStaysWhereItIs) {
  std::vector<Vec3> x;
  std::vector<Tri> triangles;
  add_sheet(5, {2, 1, 0}, {1, 0, 0}, {0, 1, 0}, x, triangles);
  const std::vector<Vec3> before = x;
  const auto surface = collision::make_surface(triangles, static_cast<Index>(x.size()));
  dressing::untangle(surface, wearer().slim(0), wearer().crossing(), kSpacing, 100, x);
  EXPECT_EQ(x, before);
}

}  // namespace
}  // namespace toile
