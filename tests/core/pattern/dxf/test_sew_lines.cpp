// Which of the closed lines of a drawing are sew lines, and which are not.

#include <vector>

#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

/// The layers of a cut line and of its sew line, as programs use them.
struct Layers {
  const char *cut, *sew;
};
constexpr Layers kAllLayers[] = {{"0", "0"},     {"1", "14"}, {"1", "8"},  {"1", "84"}, {"1", "87"},
                                 {"CUT", "SEW"}, {"A", "B"},  {"14", "1"}, {"1", "1"}};

std::string described(const Layers& layers) { return std::string(layers.cut) + " and " + layers.sew; }

/// The only piece of the drawing, on its sew line; a failure when that is not so.
dxf::DxfPiece sewn_piece(const std::string& body, const std::string& what) {
  const dxf::DxfDrawing d = read_trial(entities(body), in_mm());
  EXPECT_EQ(d.pieces.size(), 1u) << what;
  if (d.pieces.empty()) return {};
  EXPECT_TRUE(d.pieces[0].on_sew_line) << what;
  EXPECT_TRUE(d.pieces[0].holes.empty()) << what;
  EXPECT_TRUE(told(d, "gives way to the sew line")) << what;
  return d.pieces[0];
}

TEST(DxfSewLines, EachSideMayHaveAnAllowanceOfItsOwnAndAFoldNone) {
  struct Sides {
    double left, bottom, right, top;
  };
  for (const Layers& layers : kAllLayers) {
    for (const Sides s : {Sides{0, 10, 10, 10}, Sides{10, 10, 0, 10}, Sides{0, 40, 15, 10},
                          Sides{25, 40, 25, 10}, Sides{12, 0, 12, 30}, Sides{0, 30, 10, 0}}) {
      const double width = 280 - s.left - s.right, height = 650 - s.bottom - s.top;
      const std::string cut = rectangle({0, 0}, 280, 650, layers.cut),
                        sew = rectangle({s.left, s.bottom}, width, height, layers.sew);
      for (const std::string& body : {cut + sew, sew + cut})
        EXPECT_NEAR(area_of(sewn_piece(body, described(layers))), width * height, 1e-6);
    }
  }
}

TEST(DxfSewLines, DartsRunIntoThePieceFromTheSewLineAlone) {
  for (const Layers& layers : kAllLayers) {
    const std::string cut = rectangle({0, 0}, 260, 600, layers.cut);
    const std::string sew = polyline({{0, 40},
                                      {245, 40},
                                      {245, 590},
                                      {190, 590},
                                      {177, 470},
                                      {164, 590},
                                      {100, 590},
                                      {85, 450},
                                      {70, 590},
                                      {0, 590}},
                                     layers.sew);
    const double darts = 26 * 120 / 2.0 + 30 * 140 / 2.0;
    EXPECT_NEAR(area_of(sewn_piece(cut + sew, described(layers))), 245 * 550 - darts, 1e-6);
  }
}

TEST(DxfSewLines, OneThatLeavesTheCutLineByALittleMakesNoPieceOfItsOwn) {
  for (const Layers& layers : kAllLayers) {
    for (const double out : {0.05, 0.15, 0.6}) {
      const std::string body =
          rectangle({0, 0}, 280, 650, layers.cut) + rectangle({-out, 30}, 270 + out, 610, layers.sew);
      EXPECT_NEAR(area_of(sewn_piece(body, described(layers))), (270 + out) * 610, 1e-6);
    }
  }
}

TEST(DxfSewLines, NotchesMayBeCutIntoTheCutLineAtTheFold) {
  for (const Layers& layers : kAllLayers) {
    const std::string cut = polyline({{0, 0},
                                      {280, 0},
                                      {280, 300},
                                      {275, 302.5},
                                      {280, 305},
                                      {280, 650},
                                      {0, 650},
                                      {0, 402.5},
                                      {4, 400},
                                      {0, 397.5}},
                                     layers.cut);
    const std::string body = cut + rectangle({0, 30}, 270, 610, layers.sew);
    EXPECT_NEAR(area_of(sewn_piece(body, described(layers))), 270 * 610, 1e-6);
  }
}

TEST(DxfSewLines, EveryPieceHasItsOwn) {
  for (const Layers& layers : kAllLayers) {
    std::string body;
    for (int i = 0; i < 3; ++i)
      body +=
          rectangle({i * 400.0, 0}, 280, 650, layers.cut) + rectangle({i * 400.0, 30}, 270, 610, layers.sew);
    const dxf::DxfDrawing d = read_trial(entities(body), in_mm());
    ASSERT_EQ(d.pieces.size(), 3u) << described(layers);
    for (const dxf::DxfPiece& piece : d.pieces) EXPECT_NEAR(area_of(piece), 270 * 610, 1e-6);
  }
}

TEST(DxfSewLines, WhatDoesNotFollowTheCutLineIsALineWithin) {
  const std::string cut = rectangle({0, 0}, 400, 600, "1");
  const std::string opening = rectangle({120, 300}, 150, 12, "14");
  const dxf::DxfDrawing alone = read_trial(entities(cut + opening), in_mm());
  ASSERT_EQ(alone.pieces.size(), 1u);
  EXPECT_NEAR(area_of(alone.pieces[0]), 400 * 600, 1e-6) << "a pocket's opening is no sew line";
  EXPECT_FALSE(alone.pieces[0].on_sew_line);
  EXPECT_EQ(alone.pieces[0].internals.size(), 1u);
  EXPECT_TRUE(told(alone, "does not follow the cut line"));
  const dxf::DxfDrawing both =
      read_trial(entities(cut + opening + rectangle({10, 10}, 380, 580, "14")), in_mm());
  ASSERT_EQ(both.pieces.size(), 1u);
  EXPECT_NEAR(area_of(both.pieces[0]), 380 * 580, 1e-6);
  EXPECT_EQ(both.pieces[0].internals.size(), 1u);
}

TEST(DxfSewLines, WhereAFileHasThemOnTheirLayerNoOtherLayerHasThem) {
  const std::string front = rectangle({0, 0}, 300, 500, "1") + rectangle({10, 10}, 280, 480, "14");
  const std::string patch = rectangle({0, 0}, 160, 180, "1") + rectangle({6, 6}, 148, 168, "8");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"FRONT", front}, {"PATCH", patch}}), in_mm());
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_FALSE(d.pieces[1].on_sew_line) << "its top stitches";
  EXPECT_NEAR(area_of(d.pieces[1]), 160 * 180, 1e-6);
}

TEST(DxfSewLines, ALineAlongTheSewLineIsNoHole) {
  for (const double fold : {0.0, 10.0}) {
    const double stitches = fold > 0 ? fold + 6 : 0;
    const dxf::DxfDrawing d =
        read_trial(entities(rectangle({0, 0}, 300, 500) + rectangle({fold, 10}, 290 - fold, 480) +
                            rectangle({stitches, 16}, 284 - stitches, 468)),
                   in_mm());
    ASSERT_EQ(d.pieces.size(), 1u);
    EXPECT_NEAR(area_of(d.pieces[0]), (290 - fold) * 480, 1e-6);
    EXPECT_TRUE(d.pieces[0].holes.empty());
    EXPECT_EQ(d.pieces[0].internals.size(), 1u);
  }
}

TEST(DxfSewLines, SizesAndLiningsOnLayersOfTheirOwnAreNone) {
  for (const auto& [outer, inner] : std::vector<std::pair<std::string, std::string>>{
           {"38", "36"}, {"L", "M"}, {"SHELL", "LINING"}, {"A", "FUSIBLE"}}) {
    const dxf::DxfDrawing d = read_trial(
        entities(rectangle({0, 0}, 300, 500, outer) + rectangle({10, 8}, 280, 484, inner)), in_mm());
    ASSERT_EQ(d.pieces.size(), 1u) << outer;
    EXPECT_NEAR(area_of(d.pieces[0]), 300 * 500, 1e-6) << outer;
  }
}

TEST(DxfSewLines, OneThatEndsOnTheCutLineIsClosedAlongIt) {
  const std::string cut = polyline({{0, 0}, {280, 0}, {300, 300}, {280, 650}, {100, 660}, {0, 550}}, "1");
  const std::string sew =
      polyline({{0, 30}, {272, 30}, {290, 300}, {270, 640}, {105, 649}, {0, 535}}, "14", 0);
  const dxf::DxfDrawing d = read_trial(entities(cut + sew), in_mm());
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_TRUE(d.pieces[0].on_sew_line);
  EXPECT_TRUE(told(d, "closed along it"));
  EXPECT_NEAR(bounding_box(d.pieces[0].outline).size().y, 649 - 30, 1e-6);
  const std::string one_side = polyline({{270, 0}, {290, 300}, {270, 651}}, "14", 0);
  const dxf::DxfDrawing part = read_trial(entities(cut + one_side), in_mm());
  ASSERT_EQ(part.pieces.size(), 1u);
  EXPECT_TRUE(part.pieces[0].on_sew_line) << "one seam has an allowance, the other edges have none";
}

TEST(DxfSewLines, APieceOfWhichLittleIsLeftIsWarnedOf) {
  const dxf::DxfDrawing strap =
      read_trial(entities(rectangle({0, 0}, 420, 32, "1") + rectangle({10, 10}, 400, 12, "14")), in_mm());
  ASSERT_EQ(strap.pieces.size(), 1u);
  EXPECT_TRUE(strap.pieces[0].on_sew_line);
  EXPECT_TRUE(told(strap, "the sew line encloses 36 % of what the cut line does"));
  const dxf::DxfDrawing frame =
      read_trial(entities(rectangle({0, 0}, 900, 900) + rectangle({60, 60}, 780, 780)), in_mm());
  ASSERT_EQ(frame.pieces.size(), 1u);
  EXPECT_EQ(frame.pieces[0].holes.size(), 1u);
  EXPECT_TRUE(told(frame, "holes take all but 25 % of the piece"));
}

}  // namespace
}  // namespace toile
