#include "core/analysis/over_limit.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// Two pieces, each a row of ten squares of 5 cm with the warp upwards, of a fabric that may stretch by 4 %
/// along its warp and 6 % along its weft; the second stands a metre aside.
struct Rows {
  drape::DrapeInput input;
  drape::DrapeResult result;

  Rows() {
    material::Fabric fabric;
    fabric.limit_warp = 0.04;
    fabric.limit_weft = 0.06;
    input.fabrics = {fabric};
    for (const char* id : {"front", "back"}) {
      pattern::Panel panel;
      panel.id = id;
      panel.grain = {0, 1};
      input.pattern.panels.push_back(panel);
      input.fabric_of_panel.push_back(0);
      append_row(static_cast<Index>(input.pattern.panels.size()) - 1);
    }
  }

  void append_row(Index panel) {
    for (Index i = 0; i <= 10; ++i) {
      const auto v = static_cast<Index>(result.positions.size());
      for (const double y : {0.0, 0.05}) {
        result.garment.rest.push_back({0.05 * i, y});
        result.positions.push_back({0.05 * i + panel, y, 0});
      }
      if (i == 10) continue;
      result.garment.triangles.push_back({v, v + 2, v + 1});
      result.garment.triangles.push_back({v + 2, v + 3, v + 1});
      result.garment.panel_of_triangle.insert(result.garment.panel_of_triangle.end(), 2, panel);
    }
  }
};

TEST(OverLimit, ClothWithinItsLimitsIsNotNamed) {
  Rows rows;
  for (Vec3& p : rows.result.positions) p = {1.07 * p.x, 1.05 * p.y, p.z};
  EXPECT_TRUE(analysis::find_over_limit(rows.input, rows.result).empty());
}

TEST(OverLimit, ACornerThatIsDrawnOutIsNamedWithItsPieceAndPlace) {
  Rows rows;
  rows.result.positions.back().x += 0.02;  // of the piece "back"
  const preflight::Findings found = analysis::find_over_limit(rows.input, rows.result);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(preflight::code_of(found[0].kind), "strain.over_limit");
  EXPECT_EQ(found[0].about, preflight::Concerns{preflight::piece_named("back")});
  EXPECT_NEAR(found[0].place.x, 1.485, 1e-9);
  EXPECT_NE(found[0].message.find("limit of 6.0 %, by up to 40.0 %"), std::string::npos) << found[0].message;
}

TEST(OverLimit, PlacesFarFromEachOtherAreNamedApart) {
  Rows rows;
  rows.result.positions[0].x -= 0.02;
  rows.result.positions[20].x += 0.02;
  rows.result.positions[22].x -= 0.01;  // of the other piece
  EXPECT_EQ(analysis::find_over_limit(rows.input, rows.result).size(), 3u);
}

TEST(OverLimit, WithoutLimitsNothingIsBeyondThem) {
  Rows rows;
  rows.input.fabrics[0].limit_weft = 0;
  rows.result.positions.back().x += 0.02;
  EXPECT_TRUE(analysis::find_over_limit(rows.input, rows.result).empty());
}

TEST(OverLimit, TheLimitOfASlantLiesBetweenThoseOfTheThreads) {
  const Rows rows;
  const material::Fabric& fabric = rows.input.fabrics[0];
  EXPECT_NEAR(analysis::stretch_limit(fabric, {1, 0}), 0.06, 1e-12);
  EXPECT_NEAR(analysis::stretch_limit(fabric, {0, 1}), 0.04, 1e-12);
  EXPECT_NEAR(analysis::stretch_limit(fabric, {0.6, 0.8}), 0.0472, 1e-4);
}

}  // namespace
}  // namespace toile
