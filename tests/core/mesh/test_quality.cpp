#include "core/mesh/quality.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/units.h"

namespace toile {
namespace {

TEST(MeshQuality, MeasuresTwoHalvesOfASquare) {
  const std::vector<Vec2> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const mesh::MeshQuality q = mesh::quality_of(points, std::vector<Tri>{{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(q.triangles, 2);
  EXPECT_EQ(q.edges, 5);
  EXPECT_EQ(q.inverted, 0);
  EXPECT_DOUBLE_EQ(q.area, 4);
  EXPECT_NEAR(q.min_angle, kPi / 4, 1e-12);
  EXPECT_DOUBLE_EQ(q.min_edge, 2);
  EXPECT_DOUBLE_EQ(q.max_edge, std::sqrt(8));
  EXPECT_DOUBLE_EQ(q.mean_edge, (8 + std::sqrt(8)) / 5);
  EXPECT_NEAR(q.edge_deviation, 0.4 * (std::sqrt(8) - 2), 1e-12);
  EXPECT_DOUBLE_EQ(q.min_area, 2);
  EXPECT_DOUBLE_EQ(q.area_deviation, 0);
}

TEST(MeshQuality, CountsClockwiseAndFlatTriangles) {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {0, 1}, {2, 0}};
  const mesh::MeshQuality q = mesh::quality_of(points, std::vector<Tri>{{0, 2, 1}, {0, 1, 3}});
  EXPECT_EQ(q.inverted, 2);
  EXPECT_EQ(q.min_angle, 0);
  EXPECT_DOUBLE_EQ(q.area, -0.5);
}

TEST(MeshQuality, AnEmptyMeshMeasuresNothing) { EXPECT_EQ(mesh::quality_of({}, {}).triangles, 0); }

TEST(MeshQuality, TheLeastAngleOfANeedleIsAtItsTip) {
  EXPECT_NEAR(mesh::least_angle({0, 0}, {1, -0.05}, {1, 0.05}), 2 * std::atan(0.05), 1e-12);
}

}  // namespace
}  // namespace toile
