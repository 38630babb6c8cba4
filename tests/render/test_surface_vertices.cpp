#include "server/render/surface_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "server/render/panel_make.h"
#include "tests/render/draped.h"

namespace toile {
namespace {

/// Two squares of 10 cm side by side, apart or sewn along x = 0.1.
struct TwoSquares {
  std::vector<Vec3> positions{{0, 0, 0},   {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0},
                              {0.1, 0, 0}, {0.2, 0, 0}, {0.2, 0.1, 0}, {0.1, 0.1, 0}};
  std::vector<Tri> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  std::vector<Index> panels{0, 0, 1, 1};
  std::vector<Index> weld{0, 1, 2, 3, 1, 5, 6, 2};
  render::ClothView view() const { return {positions, triangles, panels, weld, {}, {}}; }
};

/// The side that both vertices of a square lie on: its slot, or none.
int slot_of(const render::ClothSurface& surface, int a, int b) {
  for (std::size_t s = 0; s < render::kBorderSlots; ++s)
    if (surface.vertices[a].lines.distance[s] == 0 && surface.vertices[b].lines.distance[s] == 0)
      return static_cast<int>(s);
  return -1;
}

constexpr float kNoBorder = -9, kOpen = -1, kSeam = 0, kHem = 2;

float kind(const render::ClothSurface& surface, int a, int b) {
  const int slot = slot_of(surface, a, b);
  return slot < 0 ? kNoBorder : surface.vertices[a].lines.kind[static_cast<std::size_t>(slot)];
}

TEST(ClothSurface, TellsSeamsFromHems) {
  const render::ClothSurface surface = render::cloth_surface(TwoSquares().view());
  ASSERT_EQ(surface.vertices.size(), 8u);
  EXPECT_EQ(kind(surface, 1, 2), kSeam);
  EXPECT_EQ(kind(surface, 4, 7), kSeam);
  EXPECT_EQ(kind(surface, 0, 1), kHem);
  EXPECT_EQ(kind(surface, 0, 2), kNoBorder) << "a diagonal is no border";
}

TEST(ClothSurface, TellsASeamThatDidNotCloseFromOneThatDid) {
  TwoSquares squares;
  for (std::size_t v = 4; v < 8; ++v) squares.positions[v].x += 0.02;
  const render::ClothSurface surface = render::cloth_surface(squares.view());
  EXPECT_EQ(kind(surface, 1, 2), kOpen);
  EXPECT_EQ(kind(surface, 4, 7), kOpen);
  EXPECT_EQ(kind(surface, 0, 1), kHem);
}

/// Corners of one triangle may lie by a seam and by a hem in the same slot: what is blended between looks
/// shut.
TEST(ClothSurface, BlendsNoOpenSeamBetweenASeamAndAHem) {
  TwoSquares squares;
  const render::ClothSurface shut = render::cloth_surface(squares.view());
  for (std::size_t v = 4; v < 8; ++v) squares.positions[v].x += 0.02;
  const render::ClothSurface open = render::cloth_surface(squares.view());
  const float seam = kind(shut, 1, 2), hem = kind(shut, 0, 1), gaping = kind(open, 1, 2);
  EXPECT_LT(gaping, std::min(seam, hem));
}

TEST(ClothSurface, HasHemsOnlyWhereNothingIsSewn) {
  const TwoSquares squares;
  render::ClothView apart = squares.view();
  apart.weld = {};
  EXPECT_EQ(kind(render::cloth_surface(apart), 1, 2), kHem);
}

TEST(ClothSurface, KeepsSidesThatMeetApart) {
  const render::ClothSurface surface = render::cloth_surface(TwoSquares().view());
  const int right = slot_of(surface, 1, 2), low = slot_of(surface, 0, 1), upper = slot_of(surface, 2, 3);
  EXPECT_NE(right, low);
  EXPECT_NE(right, upper);
  EXPECT_NE(low, upper) << "four sides have a slot each";
}

TEST(ClothSurface, MeasuresDistanceAndWayAlongABorderInMetres) {
  const render::ClothSurface surface = render::cloth_surface(TwoSquares().view());
  const auto right = static_cast<std::size_t>(slot_of(surface, 1, 2));
  EXPECT_FLOAT_EQ(surface.vertices[0].lines.distance[right], 0.1f);
  EXPECT_FLOAT_EQ(surface.vertices[1].lines.along[right], 0);
  EXPECT_FLOAT_EQ(surface.vertices[2].lines.along[right], 0.1f);
  EXPECT_FLOAT_EQ(surface.vertices[3].lines.along[right], 0.1f);
}

TEST(ClothSurface, MeasuresOnTheFlatPieceAndNotAcrossAFold) {
  // A strip of two squares folded shut: its far end lies on its beginning.
  const std::vector<Vec3> p{{0, 0, 0},   {0, 0, 0.1},     {0.1, 0, 0.1},
                            {0.1, 0, 0}, {0, 0.001, 0.1}, {0, 0.001, 0}};
  const std::vector<Tri> t{{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}};
  const std::vector<Vec2> rest{{0, 0}, {0, 0.1}, {0.1, 0.1}, {0.1, 0}, {0.2, 0.1}, {0.2, 0}};
  const render::ClothSurface surface = render::cloth_surface({p, t, {}, {}, {}, rest});
  const auto first = static_cast<std::size_t>(slot_of(surface, 0, 1));
  EXPECT_FLOAT_EQ(surface.vertices[3].lines.distance[first], 0.1f);
  EXPECT_GT(surface.vertices[5].lines.distance[first], 0.15f);
}

TEST(ClothSurface, HasTheSameLinesHoweverATriangleTouchesTheBorder) {
  // A fan about a vertex in the middle of a border: its middle triangle has no edge on it, and the line runs
  // on.
  const std::vector<Vec3> p{{-0.1, 0, 0},   {0, 0, 0},       {0.1, 0, 0},
                            {0.05, 0.1, 0}, {-0.05, 0.1, 0}, {0, 0.2, 0}};
  const std::vector<Tri> t{{1, 2, 3}, {1, 3, 4}, {1, 4, 0}, {4, 3, 5}};
  const render::ClothSurface surface = render::cloth_surface({p, t, {}, {}, {}, {}});
  const Tri& middle = surface.triangles[1];
  const auto low =
      static_cast<std::size_t>(slot_of(surface, surface.triangles[0][0], surface.triangles[0][1]));
  EXPECT_FLOAT_EQ(surface.vertices[middle[0]].lines.distance[low], 0);
  EXPECT_FLOAT_EQ(surface.vertices[middle[1]].lines.distance[low], 0.1f);
  EXPECT_FLOAT_EQ(surface.vertices[middle[2]].lines.distance[low], 0.1f);
}

TEST(ClothSurface, TakesThePanelsColourAndADefaultWhereThereIsNone) {
  const Draped skirt = folded_skirt();
  render::ClothView cloth = skirt.scene().cloth;
  cloth.colour_of_panel.resize(1);
  const render::ClothSurface surface = render::cloth_surface(cloth);
  EXPECT_FLOAT_EQ(surface.vertices.front().colour[0], 0.5f);
  EXPECT_FLOAT_EQ(surface.vertices.back().colour[0], static_cast<float>(render::kClothColour[0]));
}

TEST(ClothSurface, MakesAVertexOfTwoPanelsTwice) {
  const Draped skirt = folded_skirt();
  render::ClothView cloth = skirt.scene().cloth;
  std::vector<Tri> joined = skirt.triangles;
  for (Tri& t : joined)
    for (Index& v : t) v = skirt.weld[v];
  cloth.triangles = joined;
  EXPECT_EQ(render::cloth_surface(cloth).vertices.size(), skirt.positions.size());
}

TEST(ClothSurface, HasEqualNormalsOnBothSidesOfASeam) {
  const Draped skirt = folded_skirt();
  const render::ClothSurface surface = render::cloth_surface(skirt.scene().cloth);
  const auto normal_of = [&](Index vertex) {
    for (std::size_t t = 0; t < skirt.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const float* n = surface.vertices[static_cast<std::size_t>(surface.triangles[t][i])].normal;
        if (skirt.triangles[t][i] == vertex) return Vec3{n[0], n[1], n[2]};
      }
    }
    return Vec3{};
  };
  const Index back = static_cast<Index>(skirt.positions.size()) / 2, row = 7 * (kSkirtColumns + 1);
  EXPECT_EQ(normal_of(row + kSkirtColumns), normal_of(back + row));
  EXPECT_EQ(normal_of(row), normal_of(back + row + kSkirtColumns));
}

TEST(PanelMake, HasNarrowerHemsOnNarrowPiecesAndStitchesBesideTheSeamsOfThickCloth) {
  const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0},    {0, 1, 0},
                            {2, 0, 0}, {3, 0, 0}, {3, 0.03, 0}, {2, 0.03, 0}};
  const std::vector<Tri> t{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const std::vector<Index> panels{0, 0, 1, 1};
  render::ClothView cloth{p, t, panels, {}, {}, {}};
  cloth.look_of_panel.resize(2);
  cloth.look_of_panel[0].thickness = 0.3e-3f;
  cloth.look_of_panel[1].thickness = 1e-3f;
  const std::vector<render::PanelMake> makes = render::panel_makes(cloth);
  ASSERT_EQ(makes.size(), 2u);
  EXPECT_NEAR(makes[0].hem, 0.018, 1e-9);
  EXPECT_NEAR(makes[1].hem, 0.15 * 0.03, 5e-4);
  EXPECT_EQ(makes[0].stitched_beside, 0);
  EXPECT_GT(makes[1].stitched_beside, 0);
}

}  // namespace
}  // namespace toile
