// Blocks, inserts, comments and foreign codes of DXF files, and what the report says of them.

#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

TEST(DxfStructure, BlocksOfOneNameAreTakenByTheirOrder) {
  const dxf::DxfDrawing d = read_trial(
      blocks_and_inserts({{"P", rectangle({0, 0}, 300, 500, "1")}, {"P", rectangle({0, 0}, 200, 400, "1")}}));
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_NEAR(area_of(d.pieces[0]), 150'000, 1e-6);
  EXPECT_NEAR(area_of(d.pieces[1]), 80'000, 1e-6);
  EXPECT_TRUE(told(d, "several blocks are called 'P'"));
}

TEST(DxfStructure, OffsetsOfInsertsArePassedOverWhereTheVerticesAreAbsolute) {
  const std::string blocks =
      block("A", rectangle({0, 0}, 300, 500, "1")) + block("B", rectangle({400, 0}, 300, 500, "1"));
  const dxf::DxfDrawing d =
      read_trial(section("BLOCKS", blocks) + entities(insert("A", {0, 0}) + insert("B", {400, 0})));
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_EQ(d.pieces[1].outline[0], (Vec2{400, 0}));
  EXPECT_TRUE(told(d, "have their place in the drawing already"));
}

TEST(DxfStructure, BlocksWithinBlocksAndMirroredInserts) {
  const std::string inner = block("INNER", polyline({{0, 0}, {300, 0}, {0, 500}}, "1"));
  const std::string mirrored =
      groups({{0, "INSERT"}, {8, "1"}, {2, "INNER"}, {10, "100"}, {20, "0"}, {41, "-1"}, {42, "1"}});
  const dxf::DxfDrawing d =
      read_trial(section("BLOCKS", inner + block("OUTER", mirrored)) + entities(insert("OUTER", {50, 0})));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].outline[1], (Vec2{-150, 0}));
  const std::string itself = block("LOOP", insert("LOOP", {1, 1}) + rectangle({0, 0}, 300, 500, "1"));
  EXPECT_TRUE(told(read_trial(section("BLOCKS", itself) + entities(insert("LOOP", {0, 0}))), "too deeply"));
}

TEST(DxfStructure, CommentsAttributeTemplatesAndForeignCodesDoNoHarm) {
  const std::string polyline_with_codes =
      groups({{0, "POLYLINE"}, {8, "1"}, {66, "1"}, {70, "1"}, {71, "0"}, {250, "2"}, {39, "0.0"}}) +
      groups({{0, "VERTEX"},
              {8, "1"},
              {10, "-0.0"},
              {20, "0,0"},
              {0, "VERTEX"},
              {8, "1"},
              {10, "300"},
              {20, "0"},
              {0, "VERTEX"},
              {8, "1"},
              {10, "300,5"},
              {20, "500"},
              {0, "SEQEND"}});
  const std::string attribute = groups({{0, "ATTDEF"}, {8, "1"}, {10, "0"}, {20, "0"}, {1, "x"}, {2, "TAG"}});
  const std::string insert_with_attribute = groups({{0, "INSERT"},
                                                    {8, "1"},
                                                    {66, "1"},
                                                    {2, "A"},
                                                    {10, "0"},
                                                    {20, "0"},
                                                    {0, "ATTRIB"},
                                                    {8, "1"},
                                                    {10, "0"},
                                                    {20, "0"},
                                                    {1, "value"},
                                                    {2, "TAG"},
                                                    {0, "SEQEND"},
                                                    {8, "1"}});
  const dxf::DxfDrawing d = read_trial("999\nANSI/AAMA\n999\nsecond comment\n" +
                                       section("BLOCKS", block("A", attribute + polyline_with_codes)) +
                                       entities(insert_with_attribute));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_NEAR(area_of(d.pieces[0]), 75'000, 1e-6);
  EXPECT_TRUE(told(d, "ATTDEF makes no outline"));
}

TEST(DxfStructure, ADrawingMayStandInTheBlockOfTheModelSpace) {
  const dxf::DxfDrawing d =
      read_trial(section("BLOCKS", block("*MODEL_SPACE", rectangle({0, 0}, 300, 500))) + entities(""));
  EXPECT_EQ(d.pieces.size(), 1u);
}

TEST(DxfStructure, BlocksWithAPieceNameThatNothingInsertsAreReadAndTold) {
  const std::string blocks =
      block("A", rectangle({0, 0}, 300, 500, "1")) +
      block("B", rectangle({0, 0}, 200, 500, "1") + text({9, 9}, "Piece Name: B", "1")) +
      block("SYMBOL", rectangle({0, 0}, 20, 20, "1"));
  const dxf::DxfDrawing d = read_trial(section("BLOCKS", blocks) + entities(insert("A", {0, 0})));
  EXPECT_EQ(d.pieces.size(), 2u);
  EXPECT_TRUE(told(d, "holds a piece that nothing inserts"));
}

TEST(DxfReport, WarningsNameThePieceAndThePlace) {
  const dxf::DxfDrawing d = read_trial(
      blocks_and_inserts({{"FRONT", rectangle({20, 0}, 400, 150, "1") + line({0, 0}, {0, 150}, "6")}}));
  ASSERT_EQ(d.report.warnings.size(), 1u);
  const dxf::DxfWarning& warning = d.report.warnings[0];
  EXPECT_EQ(warning.piece, "FRONT");
  ASSERT_TRUE(warning.at);
  EXPECT_EQ(*warning.at, (Vec2{0, 0}));
  EXPECT_EQ(dxf::warning_text(warning).substr(0, 5 + 2 + 2), "line " + std::to_string(warning.line) + ", ");
}

}  // namespace
}  // namespace toile
