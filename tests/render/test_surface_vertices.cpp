#include "server/render/surface_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/render/draped.h"

namespace toile {
namespace {

/// Two squares side by side, apart or sewn along x = 1.
struct TwoSquares {
  std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                              {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
  std::vector<Tri> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  std::vector<Index> weld{0, 1, 2, 3, 1, 5, 6, 2};
  render::ClothView view() const { return {positions, triangles, {}, weld, {}, {}}; }
};

/// Strength of the line along the edge opposite corner `i` of triangle `t`.
float strength(const std::vector<render::ClothVertex>& v, int t, int i) { return v[3 * t].line_strength[i]; }

TEST(ClothVertices, DrawSeamsDarkerThanHems) {
  const TwoSquares squares;
  const std::vector<render::ClothVertex> v = render::cloth_vertices(squares.view());
  ASSERT_EQ(v.size(), 12u);
  const float seam = strength(v, 0, 0), hem = strength(v, 0, 2);  // edge 1-2 is sewn, edge 0-1 is not
  EXPECT_GT(seam, hem);
  EXPECT_GT(hem, 0);
  EXPECT_EQ(strength(v, 0, 1), 0);  // the diagonal is no border
}

TEST(ClothVertices, TellASeamThatDidNotCloseFromOneThatDid) {
  TwoSquares squares;
  for (std::size_t v = 4; v < 8; ++v) squares.positions[v].x += 0.02;
  const std::vector<render::ClothVertex> v = render::cloth_vertices(squares.view());
  EXPECT_LT(strength(v, 0, 0), 0) << "both sides are drawn in red";
  EXPECT_LT(strength(v, 3, 1), 0);
  EXPECT_GT(strength(v, 0, 2), 0) << "the hem beside it is not";
}

TEST(ClothVertices, DrawNoSeamWhereNothingIsSewn) {
  const TwoSquares squares;
  render::ClothView apart = squares.view();
  apart.weld = {};
  const std::vector<render::ClothVertex> v = render::cloth_vertices(apart);
  EXPECT_EQ(strength(v, 0, 0), strength(v, 0, 2));
}

TEST(ClothVertices, MeasureTheDistanceFromABorderInMetres) {
  const std::vector<render::ClothVertex> v = render::cloth_vertices(TwoSquares().view());
  EXPECT_FLOAT_EQ(v[0].line_distance[0], 1);  // corner 0 lies a metre off the seam
  EXPECT_FLOAT_EQ(v[1].line_distance[0], 0);
  EXPECT_FLOAT_EQ(v[2].line_distance[0], 0);
}

TEST(ClothVertices, CarryALineOnThroughATriangleThatOnlyTouchesIt) {
  // A fan about vertex 1 of the border 0-1-2: its middle triangle has that vertex on the border, and no edge.
  const std::vector<Vec3> p{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {-0.5, 1, 0}, {0, 2, 0}};
  const std::vector<Tri> t{{1, 2, 3}, {1, 3, 4}, {1, 4, 0}, {4, 3, 5}};
  const std::vector<render::ClothVertex> v = render::cloth_vertices({p, t, {}, {}, {}, {}});
  EXPECT_GT(strength(v, 1, 0), 0);
  EXPECT_FLOAT_EQ(v[3].line_distance[0], 0);
  EXPECT_FLOAT_EQ(v[4].line_distance[0], 1);
  EXPECT_FLOAT_EQ(v[5].line_distance[0], 1);
}

TEST(ClothVertices, TakeThePanelsColourAndADefaultWhereThereIsNone) {
  const Draped skirt = folded_skirt();
  render::ClothView cloth = skirt.scene().cloth;
  cloth.colour_of_panel.resize(1);
  const std::vector<render::ClothVertex> v = render::cloth_vertices(cloth);
  EXPECT_FLOAT_EQ(v.front().colour[0], 0.5f);
  EXPECT_FLOAT_EQ(v.back().colour[0], static_cast<float>(render::kClothColour[0]));
}

TEST(ClothVertices, HaveEqualNormalsOnBothSidesOfASeam) {
  const Draped skirt = folded_skirt();
  const std::vector<render::ClothVertex> v = render::cloth_vertices(skirt.scene().cloth);
  const auto normal_of = [&](Index vertex) {
    for (std::size_t t = 0; t < skirt.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const float* n = v[3 * t + i].normal;
        if (skirt.triangles[t][i] == vertex) return Vec3{n[0], n[1], n[2]};
      }
    }
    return Vec3{};
  };
  const Index back = static_cast<Index>(skirt.positions.size()) / 2, row = 7 * (kSkirtColumns + 1);
  EXPECT_EQ(normal_of(row + kSkirtColumns), normal_of(back + row));
  EXPECT_EQ(normal_of(row), normal_of(back + row + kSkirtColumns));
}

}  // namespace
}  // namespace toile
