#include "core/warm/flat_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"

namespace toile {
namespace {

const std::vector<std::string> kEdges{"e0", "e1", "e2", "e3"};

pattern::Pattern sheet(double hem) {
  return {{test::polygon("sheet", {{0, -hem}, {300, -hem}, {300, 400}, {0, 400}})}, {}};
}

mesh::PanelMeshes finely_meshed(const pattern::Pattern& pattern) {
  return mesh::make_panel_meshes(pattern, 0.02, {}).value();
}

warm::HungPiece piece_of(const pattern::Pattern& pattern) {
  return warm::flat_pieces(pattern, finely_meshed(pattern)).pieces[0];
}

TEST(PlacesBefore, AreWhereTheyWereInAPieceThatNobodyChanged) {
  const mesh::PanelMesh now = finely_meshed(sheet(0)).panels[0];
  EXPECT_EQ(warm::places_before(piece_of(sheet(0)), now, kEdges), now.rest);
}

TEST(PlacesBefore, ShareOutALongerPieceOverTheWholeOfTheOldOne) {
  const mesh::PanelMesh now = finely_meshed(sheet(100)).panels[0];  // 500 mm long, 400 before
  const std::vector<Vec2> places = warm::places_before(piece_of(sheet(0)), now, kEdges);
  for (std::size_t v = 0; v < places.size(); ++v) {
    EXPECT_NEAR(places[v].x, now.rest[v].x, 1e-3);
    EXPECT_NEAR(places[v].y, (now.rest[v].y + 0.1) * 0.8, 5e-3);
  }
}

TEST(PlacesBefore, OfAChangeAtOneEndFadeTowardsTheOther) {
  pattern::Pattern edited{{test::polygon("sheet", {{0, 0}, {320, 0}, {300, 400}, {0, 400}})}, {}};
  const mesh::PanelMesh now = finely_meshed(edited).panels[0];
  const std::vector<Vec2> places = warm::places_before(piece_of(sheet(0)), now, kEdges);
  double most = 0, far = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const double way = length(places[v] - now.rest[v]);
    most = std::max(most, way);
    if (now.rest[v].x < 0.05) far = std::max(far, way);
  }
  EXPECT_NEAR(most, 0.02, 1e-6);
  EXPECT_LT(far, 0.005);
}

TEST(PlacesBefore, TakeEdgesThatWereNotThereToTheNearestPlaceOnTheBorder) {
  // The hem, 30 mm lower, is two edges now.
  pattern::Pattern edited{{test::polygon("sheet", {{0, -30}, {150, -30}, {300, -30}, {300, 400}, {0, 400}})},
                          {}};
  const mesh::PanelMesh now = finely_meshed(edited).panels[0];
  const std::vector<Vec2> places =
      warm::places_before(piece_of(sheet(0)), now, {"left hem", "right hem", "e1", "e2", "e3"});
  for (const Vec2& p : places) {
    EXPECT_GE(p.y, -1e-9);
    EXPECT_LE(p.y, 0.4 + 1e-9);
  }
}

}  // namespace
}  // namespace toile
