#include "core/geometry/convex_hull.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(ConvexHull, SpansHollowsStraight) {
  EXPECT_NEAR(geometry::hull_perimeter({{0, 0}, {1, 0}, {1, 1}, {0.5, 0.2}, {0, 1}, {0.5, 0}}), 4, 1e-12);
  EXPECT_EQ(geometry::hull_perimeter({{1, 2}}), 0);
  EXPECT_EQ(geometry::hull_perimeter({}), 0);
}

TEST(ConvexHull, HasItsCornersCounterClockwiseAndNothingElse) {
  const std::vector<Vec2> square =
      geometry::convex_hull({{1, 1}, {0.5, 0.5}, {0, 0}, {0, 1}, {0.5, 0}, {1, 0}, {1, 0}});
  EXPECT_EQ(square, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(geometry::convex_hull({{2, 3}, {2, 3}}), (std::vector<Vec2>{{2, 3}}));
}

}  // namespace
}  // namespace toile
