#include "core/collision/crossings.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/crew.h"

namespace toile {
namespace {

TEST(Crossings, OrientationIsExactWhereDoublesWouldRound) {
  // A point one grid unit off a plane through far corners.
  const std::int64_t far = std::int64_t{1} << 30;
  const collision::ExactPoint a{-far, -far, -far}, b{far, far - 1, far}, c{far, -far, 1};
  const collision::ExactPoint on{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  const int below = collision::orientation(a, b, c, {on.x, on.y - 1, on.z}),
            above = collision::orientation(a, b, c, {on.x, on.y + 1, on.z});
  EXPECT_EQ(below, -above);
  EXPECT_NE(below, 0);
  EXPECT_EQ(collision::orientation(a, b, c, b), 0);
}

TEST(Crossings, OrientationChangesSignWhenTwoCornersSwap) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(-3, 3);
  for (int i = 0; i < 2000; ++i) {
    collision::ExactPoint p[4];
    for (collision::ExactPoint& q : p) q = {coordinate(random), coordinate(random), coordinate(random)};
    EXPECT_EQ(collision::orientation(p[0], p[1], p[2], p[3]),
              -collision::orientation(p[1], p[0], p[2], p[3]));
    EXPECT_EQ(collision::orientation(p[0], p[1], p[2], p[3]), collision::orientation(p[1], p[2], p[0], p[3]));
  }
}

TEST(Crossings, TouchingIsNoCrossing) {
  const collision::ExactPoint a{0, 0, 0}, b{10, 0, 0}, c{0, 10, 0};
  EXPECT_TRUE(collision::segment_crosses_triangle({2, 2, -5}, {2, 2, 5}, a, b, c));
  EXPECT_FALSE(collision::segment_crosses_triangle({2, 2, 0}, {2, 2, 5}, a, b, c)) << "ends on the face";
  EXPECT_FALSE(collision::segment_crosses_triangle({5, 0, -5}, {5, 0, 5}, a, b, c))
      << "passes through an edge";
  EXPECT_FALSE(collision::segment_crosses_triangle({0, 0, -5}, {0, 0, 5}, a, b, c))
      << "passes through a corner";
  EXPECT_FALSE(collision::segment_crosses_triangle({-5, 2, 0}, {20, 2, 0}, a, b, c)) << "lies in the plane";
}

/// Every pair of triangles without a shared vertex, by the definition.
int brute_force_self(const std::vector<Tri>& triangles, const std::vector<Vec3>& x) {
  int count = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < triangles.size(); ++j) {
      collision::ExactPoint a[3], b[3];
      for (int k = 0; k < 3; ++k) {
        a[k] = collision::to_grid(x[triangles[i][k]]);
        b[k] = collision::to_grid(x[triangles[j][k]]);
      }
      bool crosses = false;
      for (int k = 0; k < 3; ++k) {
        crosses |= collision::segment_crosses_triangle(a[k], a[(k + 1) % 3], b[0], b[1], b[2]);
        crosses |= collision::segment_crosses_triangle(b[k], b[(k + 1) % 3], a[0], a[1], a[2]);
      }
      count += crosses;
    }
  }
  return count;
}

struct Strewn {
  std::vector<Vec3> x;
  std::vector<Tri> triangles;
};

/// 300 triangles that share no corner, about centres from `low` to `high`, corners up to `reach` off them.
Strewn strewn(std::mt19937& random, double low, double high, double reach) {
  std::uniform_real_distribution<double> place(low, high), size(-reach, reach);
  Strewn out;
  for (Index t = 0; t < 300; ++t) {
    const Vec3 centre{place(random), place(random), place(random)};
    for (int k = 0; k < 3; ++k) out.x.push_back(centre + Vec3{size(random), size(random), size(random)});
    out.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return out;
}

TEST(Crossings, CountsWhatBruteForceCounts) {
  std::mt19937 random(11);
  const auto [x, triangles] = strewn(random, -0.5, 0.5, 0.1);
  const collision::Surface surface = collision::make_surface(triangles, static_cast<Index>(x.size()));
  const int expected = brute_force_self(triangles, x);
  ASSERT_GT(expected, 20);
  EXPECT_EQ(static_cast<int>(collision::self_crossings(surface, x).size()), expected);

  // Split in two: as cloth and body the pairs between the halves remain.
  const std::vector<Tri> first(triangles.begin(), triangles.begin() + 150),
      rest(triangles.begin() + 150, triangles.end());
  const auto count = [&](const std::vector<Tri>& part) {
    return static_cast<int>(
        collision::self_crossings(collision::make_surface(part, static_cast<Index>(x.size())), x).size());
  };
  const auto between = collision::body_crossings(collision::make_surface(first, static_cast<Index>(x.size())),
                                                 x, collision::make_crossing_body(x, rest));
  EXPECT_EQ(static_cast<int>(between.size()), expected - count(first) - count(rest));
}

TEST(Crossings, WhatDidNotMoveNeedsNoLook) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> size(-0.2, 0.2);
  auto [x, triangles] = strewn(random, 0, 1, 0.2);
  const collision::CrossingBody body =
      collision::make_crossing_body(x, std::vector<Tri>(triangles.begin() + 200, triangles.end()));
  triangles.resize(200);
  const collision::Surface surface = collision::make_surface(triangles, static_cast<Index>(x.size()));
  collision::CrossingCounter counter(surface);
  Crew crew(2);
  collision::CrossingPairs itself, with_body;
  std::uniform_int_distribution<std::size_t> any(0, 599);
  for (const int moved : {0, 1, 20, 400, 3, 0}) {  // none, few, most of them
    for (int i = 0; i < moved; ++i) x[any(random)] += Vec3{size(random), size(random), size(random)};
    counter.place(x);
    itself = counter.with_itself(std::move(itself), crew);
    with_body = counter.with(body, std::move(with_body), crew);
    EXPECT_GT(itself.size(), 20u);
    EXPECT_GT(with_body.size(), 20u);
    EXPECT_EQ(itself, collision::self_crossings(surface, x)) << moved;
    EXPECT_EQ(with_body, collision::body_crossings(surface, x, body)) << moved;
  }
}

TEST(Crossings, FindsAFoldedCornerOfTwoTrianglesThatShareAVertex) {
  // Two triangles meet in vertex 0; the far edge of the second is pushed through the first.
  const std::vector<Tri> triangles{{0, 1, 2}, {0, 3, 4}};
  const std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.3}, {0.3, 0.3, -0.3}};
  EXPECT_EQ(collision::self_crossings(collision::make_surface(triangles, 5), x).size(), 1u);
}

TEST(Crossings, SewnVerticesCountAsShared) {
  // The same corner, unsewn then sewn: two vertices at one place.
  const std::vector<Tri> triangles{{0, 1, 2}, {3, 4, 5}};
  const std::vector<Vec3> x{{0, 0, 0},        {1, 0, 0},        {0, 1, 0},
                            {0.1, 0.1, 1e-4}, {-0.5, 0.6, 0.4}, {0.1, 0.1, -0.4}};
  EXPECT_EQ(collision::self_crossings(collision::make_surface(triangles, 6), x).size(), 1u);
  const std::vector<Index> sewn{0, 1, 2, 0, 4, 5};
  EXPECT_EQ(collision::self_crossings(collision::make_surface(triangles, 6, sewn), x).size(), 0u);
}

}  // namespace
}  // namespace toile
