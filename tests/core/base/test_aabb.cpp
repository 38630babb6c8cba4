#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/aabb.h"

namespace toile {
namespace {

TEST(Aabb, HoldsTheFirstPointAloneAndThenAllThatAreAdded) {
  Aabb3 box;
  EXPECT_TRUE(box.empty());
  box.add({1, 2, 3});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.size(), Vec3{});
  box.add({-1, 5, 3});
  EXPECT_EQ(box, (Aabb3{{-1, 2, 3}, {1, 5, 3}}));
  EXPECT_EQ(box.middle(), (Vec3{0, 3.5, 3}));
}

TEST(Aabb, CountsItsSidesAsItsOwn) {
  const Aabb2 box{{0, 0}, {2, 1}};
  EXPECT_TRUE(box.contains(Vec2{2, 0}));
  EXPECT_FALSE(box.contains(Vec2{2.001, 0}));
  EXPECT_TRUE(box.contains(box));
  EXPECT_FALSE(box.contains(box.grown(0.001)));
}

TEST(Aabb, KeepsTheSignOfTheZeroThatCameFirst) {
  const Aabb2 box = bounding_box(std::vector<Vec2>{{0.0, -0.0}, {-0.0, 0.0}});
  EXPECT_FALSE(std::signbit(box.low.x));
  EXPECT_FALSE(std::signbit(box.high.x));
  EXPECT_TRUE(std::signbit(box.low.y));
  EXPECT_TRUE(std::signbit(box.high.y));
}

TEST(Aabb, OfNoPointsIsANullBoxAtTheOrigin) {
  EXPECT_EQ(bounding_box(std::vector<Vec3>{}), (Aabb3{{0, 0, 0}, {0, 0, 0}}));
}

}  // namespace
}  // namespace toile
