// How far a solid may move among cloth that stands still.

#include "core/collision/obstacle_way.h"

#include <gtest/gtest.h>

#include <random>

#include "core/collision/crossings.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

constexpr double kTop = 0.3;  // m, of the column

/// A level square of cloth, 30 cm wide, 1 mm above the column's head.
struct SheetAbove {
  std::vector<Vec3> x;
  std::vector<Tri> triangles;

  SheetAbove() {
    constexpr int kSide = 16;
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) x.push_back({0.02 * i - 0.151, kTop + 1e-3, 0.02 * j - 0.152});
    for (int i = 0; i + 1 < kSide; ++i) {
      for (int j = 0; j + 1 < kSide; ++j) {
        const Index v = i * kSide + j;
        triangles.push_back({v, v + 1, v + kSide});
        triangles.push_back({v + 1, v + kSide + 1, v + kSide});
      }
    }
  }
  collision::Surface surface() const {
    return collision::make_surface(triangles, static_cast<Index>(x.size()));
  }
};

std::vector<Vec3> shifted(std::span<const Vec3> x, Vec3 by) {
  std::vector<Vec3> out(x.begin(), x.end());
  for (Vec3& p : out) p += by;
  return out;
}

class ObstacleWays : public testing::Test {
 protected:
  collision::ObstacleWay way(std::span<const Vec3> to) {
    ways.place(sheet.x);
    return ways.way(obstacle, to, boxes);
  }

  SheetAbove sheet;
  body::Body column = test::column(0.06, 0, kTop);
  collision::Obstacle obstacle =
      collision::make_obstacle(column.mesh.vertices, column.mesh.triangles, 0.4, 1e-3);
  collision::ObstacleWays ways{sheet.surface()};
  collision::FeatureBoxes boxes;
};

TEST_F(ObstacleWays, EndsAtHalfTheGapToTheClothThatIsInTheWay) {
  const collision::ObstacleWay up = way(shifted(obstacle.vertices, {0, 0.01, 0}));
  EXPECT_NEAR(up.share * 0.01, 0.5e-3, 1e-9);
  ASSERT_NE(up.vertex, kNone);
  EXPECT_LT(std::abs(sheet.x[up.vertex].x), 0.1) << "above the column";
}

TEST_F(ObstacleWays, IsFreeAlongTheClothAndAwayFromIt) {
  for (const Vec3 by : {Vec3{0.05, 0, 0}, Vec3{0, -0.1, 0}, Vec3{0.03, -0.02, 0.1}}) {
    const collision::ObstacleWay free = way(shifted(obstacle.vertices, by));
    EXPECT_EQ(free.share, 1);
    EXPECT_EQ(free.vertex, kNone);
  }
}

TEST_F(ObstacleWays, LeadsThroughNoClothWhateverItsDirectionAndShape) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> somewhere(-0.02, 0.02), size(0.8, 1.4);
  int shortened = 0;
  for (int round = 0; round < 300; ++round) {
    const double wide = size(random);
    std::vector<Vec3> to =
        shifted(obstacle.vertices, {somewhere(random), somewhere(random), somewhere(random)});
    for (Vec3& p : to) p = {p.x * wide + somewhere(random) / 8, p.y, p.z * wide};
    const double share = way(to).share;
    shortened += share < 1 ? 1 : 0;
    for (std::size_t v = 0; v < to.size(); ++v)
      to[v] = obstacle.vertices[v] + (to[v] - obstacle.vertices[v]) * share;
    const auto solid = collision::make_crossing_body(to, column.mesh.triangles);
    ASSERT_TRUE(collision::body_crossings(sheet.surface(), sheet.x, solid).empty()) << "round " << round;
    collision::move_obstacle(obstacle, to);
    if (round % 20 == 19) collision::move_obstacle(obstacle, column.mesh.vertices);
  }
  EXPECT_GT(shortened, 50) << "the cloth was in the way often enough to tell";
}

TEST_F(ObstacleWays, AMovedObstacleIsAsOneMadeThere) {
  const std::vector<Vec3> there = shifted(obstacle.vertices, {0.2, 0.1, -0.3});
  collision::move_obstacle(obstacle, there);
  const collision::Obstacle made = collision::make_obstacle(there, column.mesh.triangles, 0.4, 1e-3);
  EXPECT_EQ(obstacle.vertices, made.vertices);
  EXPECT_EQ(obstacle.vertex_normals, made.vertex_normals);
  EXPECT_EQ(obstacle.edge_normals, made.edge_normals);
  EXPECT_EQ(obstacle.face_normals, made.face_normals);
  EXPECT_EQ(obstacle.edge_lines.size(), made.edge_lines.size());
}

}  // namespace
}  // namespace toile
