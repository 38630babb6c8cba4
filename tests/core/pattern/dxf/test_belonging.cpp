// Whose the grain lines, lines and marks of a drawing are, and marks that stand there twice.

#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

TEST(DxfBelonging, WhatStandsInThePiecesBlockIsThePiecesAlthoughItLeavesIt) {
  const std::string front = rectangle({0, 0}, 300, 500, "1") + line({150, -80}, {150, 620}, "7") +
                            point({400, 250}, "13") + line({250, 100}, {380, 100}, "8") +
                            line({-200, 50}, {-150, 50}, "8");
  const std::string back = rectangle({1000, 0}, 300, 500, "1");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"FRONT", front}, {"BACK", back}}), in_mm());
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_EQ(d.pieces[0].grain, (Vec2{0, 1}));
  EXPECT_EQ(d.pieces[0].drills.size(), 1u);
  EXPECT_EQ(d.pieces[0].internals.size(), 2u);
  EXPECT_EQ(d.report.dropped, 0u);
  EXPECT_FALSE(d.pieces[1].grain);
}

TEST(DxfBelonging, OfTwoPiecesInABlockALineIsThatOneItCrossesMost) {
  const std::string both = rectangle({0, 0}, 300, 500, "1") + rectangle({340, 0}, 300, 500, "1") +
                           line({320, 250}, {680, 250}, "7") + line({-30, 90}, {40, 90}, "8") +
                           line({700, 90}, {760, 90}, "8");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"ALL", both}}), in_mm());
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_FALSE(d.pieces[0].grain);
  EXPECT_EQ(d.pieces[1].grain, (Vec2{1, 0}));
  EXPECT_EQ(d.pieces[0].internals.size(), 1u);
  EXPECT_EQ(d.pieces[1].internals.size(), 1u) << "the nearest piece of the block";
}

TEST(DxfBelonging, InDrawingsWithoutBlocksALineIsThePiecesThatItLiesIn) {
  const std::string pieces = rectangle({0, 0}, 300, 500, "1") + rectangle({340, 0}, 300, 500, "1");
  const dxf::DxfDrawing d = read_trial(
      entities(pieces + line({150, -80}, {150, 620}, "7") + line({800, 0}, {800, 90}, "8")), in_mm());
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_EQ(d.pieces[0].grain, (Vec2{0, 1}));
  EXPECT_TRUE(told(d, "belongs to no piece")) << "nobody knows whose the line beside them is";
  const dxf::DxfDrawing free = read_trial(
      entities(rectangle({0, 0}, 300, 500) + line({100, 100}, {100, 510}) + line({-600, 600}, {900, 600})),
      in_mm());
  ASSERT_EQ(free.pieces.size(), 1u);
  EXPECT_EQ(free.pieces[0].internals.size(), 1u) << "most of it lies in the piece; the sheet's edge does not";
}

TEST(DxfBelonging, ANotchOnBothLinesIsOne) {
  const std::string lines = rectangle({0, 0}, 300, 500, "1") + rectangle({12, 30}, 276, 458, "14");
  // At the right: a double notch, one slanting; at the hem; at the left on the cut line alone.
  const std::string cut = point({300, 250}, "4") + point({300, 262}, "4") + point({150, 0}, "4") +
                          point({0, 100}, "4"),
                    sew = point({288, 250}, "4") + point({288, 264.5}, "4") + point({150, 30}, "4");
  for (const std::string& marks : {cut + sew, sew + cut}) {
    const dxf::DxfDrawing d = read_trial(entities(lines + marks), in_mm());
    ASSERT_EQ(d.pieces.size(), 1u);
    EXPECT_EQ(panel_of(d.pieces[0]).notches.size(), 4u);
    EXPECT_TRUE(told(d, "the sew line has this notch too"));
  }
  const dxf::DxfDrawing once = read_trial(entities(lines + cut), in_mm());
  EXPECT_EQ(panel_of(once.pieces.at(0)).notches.size(), 4u);
  const dxf::DxfDrawing as_lines = read_trial(
      entities(lines + line({300, 250}, {294, 250}, "4") + line({288, 250}, {284, 250}, "4")), in_mm());
  EXPECT_EQ(panel_of(as_lines.pieces.at(0)).notches.size(), 1u);
}

TEST(DxfBelonging, ANotchFarFromTheOutlineIsDroppedAndTold) {
  const dxf::DxfDrawing d = read_trial(
      blocks_and_inserts({{"FRONT", rectangle({0, 0}, 300, 500, "1") + point({150, 250}, "4")}}), in_mm());
  EXPECT_TRUE(d.pieces.at(0).notches.empty());
  EXPECT_TRUE(told(d, "a notch away from the outline"));
}

}  // namespace
}  // namespace toile
