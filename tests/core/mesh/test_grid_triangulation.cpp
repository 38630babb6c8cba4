#include "core/mesh/grid_triangulation.h"

#include <gtest/gtest.h>

#include "core/mesh/morton.h"
#include "core/mesh/topology.h"

namespace toile {
namespace {

using Kind = mesh::GridConflict::Kind;
constexpr std::int64_t kFar = mesh::kGridLimit - 1;

TEST(GridPredicates, OrientationIsExactAtTheEndsOfTheGrid) {
  EXPECT_EQ(mesh::orientation({-kFar, -kFar}, {kFar, kFar}, {0, 0}), 0);
  EXPECT_GT(mesh::orientation({-kFar, -kFar}, {kFar, kFar}, {0, 1}), 0);
  EXPECT_LT(mesh::orientation({-kFar, -kFar}, {kFar, kFar}, {1, 0}), 0);
}

TEST(GridPredicates, InCircleTellsAPointOneStepInsideFromOneOnTheCircle) {
  const mesh::GridPoint a{kFar, 0}, b{0, kFar}, c{-kFar, 0};
  EXPECT_FALSE(mesh::in_circle(a, b, c, {0, -kFar}));
  EXPECT_TRUE(mesh::in_circle(a, b, c, {0, -kFar + 1}));
  EXPECT_FALSE(mesh::in_circle(a, b, c, {1, -kFar}));
}

TEST(MortonOrder, FollowsTheZCurve) {
  const std::vector<mesh::GridPoint> points{{1, 1}, {2, 0}, {0, 1}, {1, 0}, {0, 0}};
  EXPECT_EQ(mesh::morton_order(points, 5), (std::vector<Index>{4, 3, 2, 0, 1}));
  EXPECT_EQ(mesh::morton_code({0x7fffffff, 0}), 0x1555555555555555u);
}

TEST(GridTriangulation, ForcesALongConstraintThroughManyEdges) {
  // A ladder of points above and below the middle line: without the constraint no edge follows it.
  std::vector<mesh::GridPoint> points{{0, 1000}, {4000, 1000}, {4000, 2500}, {0, 2500}};
  for (std::int64_t i = 0; i < 19; ++i) points.push_back({200 + 200 * i, i % 2 == 0 ? 1003 : 1009});
  std::vector<std::array<Index, 2>> constraints{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  mesh::GridTriangulation mesh(points);
  ASSERT_FALSE(mesh.build(constraints));
  const std::vector<Tri> triangles = mesh.inside_triangles();
  const auto n = static_cast<Index>(points.size());
  ASSERT_TRUE(mesh::check_manifold(triangles, n));
  EXPECT_EQ(mesh::euler_characteristic(triangles, n), 1);
  std::int64_t twice_area = 0;
  for (const Tri& t : triangles) {
    const std::int64_t part = mesh::orientation(points[t[0]], points[t[1]], points[t[2]]);
    EXPECT_GT(part, 0);
    twice_area += part;
  }
  EXPECT_EQ(twice_area, 2 * 4000 * 1500);
}

TEST(GridTriangulation, APointCostsHardlyMoreAmongManyThanAmongFew) {
  const auto work_each = [](std::int64_t side) {
    std::vector<mesh::GridPoint> points{{0, 0}, {100 * side, 0}, {100 * side, 100 * side}, {0, 100 * side}};
    for (std::int64_t y = 1; y < side; ++y) {
      for (std::int64_t x = 1; x < side; ++x) points.push_back({100 * x + y % 2 * 50, 100 * y});
    }
    mesh::GridTriangulation mesh(points);
    EXPECT_FALSE(mesh.build(std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
    return double(mesh.work()) / double(points.size());
  };
  const double few = work_each(40), many = work_each(160);  // 1,525 and 25,285 points
  EXPECT_LT(few, 15);
  EXPECT_LT(many, 2 * few);  // a search that began anywhere would cost four times as much
}

TEST(GridTriangulation, NoVertexLiesInsideATrianglesCircle) {
  std::vector<mesh::GridPoint> points{{0, 0}, {10000, 0}, {10000, 10000}, {0, 10000}};
  std::uint64_t state = 7;
  for (int i = 0; i < 200; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    points.push_back({1 + std::int64_t(state >> 33) % 9999, 1 + std::int64_t(state >> 13 & 0xfffff) % 9999});
  }
  mesh::GridTriangulation mesh(points);
  ASSERT_FALSE(mesh.build(std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  for (const Tri& t : mesh.inside_triangles()) {
    for (const mesh::GridPoint& p : points)
      EXPECT_FALSE(mesh::in_circle(points[t[0]], points[t[1]], points[t[2]], p));
  }
}

TEST(GridTriangulation, APointOnAnEdgeOfOthersLeavesNoFlatTriangle) {
  const std::vector<mesh::GridPoint> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {4, 4}, {2, 2}, {4, 0}, {6, 6}};
  mesh::GridTriangulation mesh(points);
  ASSERT_FALSE(mesh.build(std::vector<std::array<Index, 2>>{{0, 6}, {6, 1}, {1, 2}, {2, 3}, {3, 0}}));
  for (const Tri& t : mesh.inside_triangles()) {
    EXPECT_GT(mesh::orientation(points[t[0]], points[t[1]], points[t[2]]), 0);
  }
  EXPECT_EQ(mesh.inside_triangles().size(), 9u);
}

Kind conflict_of(std::vector<mesh::GridPoint> points, std::vector<std::array<Index, 2>> constraints) {
  mesh::GridTriangulation mesh(std::move(points));
  const auto conflict = mesh.build(constraints);
  EXPECT_TRUE(conflict);
  return conflict ? conflict->kind : static_cast<Kind>(-1);
}

TEST(GridTriangulation, SaysWhyConstraintsCannotBeLaid) {
  EXPECT_EQ(conflict_of({{0, 0}, {5, 5}, {0, 0}}, {}), Kind::kSamePlace);
  EXPECT_EQ(conflict_of({{0, 0}, {10, 0}, {5, 0}, {5, 5}}, {{0, 1}, {1, 3}, {3, 0}}), Kind::kTouch);
  EXPECT_EQ(conflict_of({{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {{0, 1}, {2, 3}}), Kind::kCross);
  EXPECT_EQ(conflict_of({{0, 0}, {10, 0}, {5, 5}}, {{0, 1}, {1, 2}}), Kind::kNotClosed);
  EXPECT_EQ(conflict_of({{0, 0}, {10, 0}, {5, 5}}, {{1, 0}, {0, 2}, {2, 1}}), Kind::kNotClosed);
}

TEST(GridTriangulation, DoesNotMoveAVertexAcrossItsNeighbours) {
  mesh::GridTriangulation mesh({{0, 0}, {100, 0}, {100, 100}, {0, 100}, {50, 50}});
  ASSERT_FALSE(mesh.build(std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  EXPECT_FALSE(mesh.move(4, {150, 50}));
  EXPECT_FALSE(mesh.move(4, {100, 50}));
  EXPECT_EQ(mesh.point(4), (mesh::GridPoint{50, 50}));
  EXPECT_TRUE(mesh.move(4, {99, 50}));
  EXPECT_EQ(mesh.point(4), (mesh::GridPoint{99, 50}));
}

}  // namespace
}  // namespace toile
