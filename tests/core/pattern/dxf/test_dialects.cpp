// What pattern systems write: each oddity in a small file of its own.

#include <initializer_list>
#include <utility>

#include "core/pattern/validate.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

TEST(DxfOutline, TheBreaksOfOpenPolylinesAreEdgeBoundaries) {
  // A side in two runs, straight on; a doubled vertex; an edge of 0.0001 inch.
  const std::string body =
      polyline({{0, 0}, {150, 0}}, "1", 0) + polyline({{150, 0}, {300, 0}, {300, 0}}, "1", 0) +
      polyline({{300, 0}, {300, 0.00254}}, "1", 0) + polyline({{300, 0.00254}, {300, 500}}, "1", 0) +
      polyline({{300, 500}, {0, 500}}, "1", 0) + polyline({{0, 500}, {0, 0}}, "1", 0);
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"A", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_TRUE(d.pieces[0].breaks_are_edges);
  const pattern::Panel panel = panel_of(d.pieces[0]);
  EXPECT_EQ(panel.outline.edges.size(), 5u) << "two of them in one line";
  EXPECT_NEAR(pattern::arc_length(panel.outline.edges[0]), 150, 1e-6);
  EXPECT_NEAR(pattern::signed_area(panel.outline), 150'000, 1);
}

TEST(DxfOutline, RunsInTheOtherDirectionAndWindingMakeTheSamePiece) {
  const std::string body = polyline({{300, 0}, {0, 0}}, "1", 0) + polyline({{0, 500}, {300, 500}}, "1", 0) +
                           polyline({{0, 0}, {0, 500}}, "1", 0) + polyline({{300, 0}, {300, 500}}, "1", 0);
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"A", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_NEAR(pattern::signed_area(panel_of(d.pieces[0]).outline), 150'000, 1);
}

TEST(DxfOutline, TheClosedFlagMayComeWithTheFirstVertexRepeatedOrNotAtAll) {
  for (const int flag : {0, 1, 8, 9, 128, 129}) {
    const dxf::DxfDrawing d =
        read_trial(entities(polyline({{0, 0}, {300, 0}, {300, 500}, {0, 500}, {0, 0}}, "1", flag)));
    ASSERT_EQ(d.pieces.size(), 1u) << flag;
    EXPECT_EQ(d.pieces[0].outline.size(), 4u) << flag;
  }
}

TEST(DxfOutline, GapsUnderAMillimetreAreClosedAndTold) {
  const dxf::DxfDrawing d =
      read_trial(entities(polyline({{0, 0}, {300, 0}, {300, 500}, {0, 500}, {0, 0.6}}, "1", 0)));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_TRUE(told(d, "a gap of 0.6 mm and was closed"));
}

TEST(DxfOutline, SmallLoopsAreCutOffAndTold) {
  // The last corner is passed by half a millimetre and come back to, as bad offsets do.
  const dxf::DxfDrawing d =
      read_trial(entities(polyline({{0, 0}, {300, 0}, {300, 500}, {-0.5, 500}, {0.5, 499}, {0, 501}}, "1")));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_TRUE(told(d, "was cut off the outline"));
  EXPECT_TRUE(pattern::validate(panel_of(d.pieces[0])));
  EXPECT_NEAR(area_of(d.pieces[0]), 150'000, 200);
}

TEST(DxfOutline, APieceThatCrossesItselfIsLeftOutBesideGoodOnes) {
  const dxf::DxfDrawing d = read_trial(
      entities(rectangle({0, 0}, 300, 500) + polyline({{900, 0}, {1000, 100}, {1000, 0}, {900, 100}})));
  EXPECT_EQ(d.pieces.size(), 1u);
  EXPECT_TRUE(told(d, "the piece is left out: The outline crosses"));
}

TEST(DxfOutline, EllipsesAndSplinesThroughPointsAreCurves) {
  const std::string half = groups({{0, "ELLIPSE"},
                                   {8, "0"},
                                   {10, "0"},
                                   {20, "0"},
                                   {11, "300"},
                                   {21, "0"},
                                   {40, "0.5"},
                                   {41, "0"},
                                   {42, "3.14159265358979"}});
  const dxf::DxfDrawing d = read_trial(entities(half + line({-300, 0}, {300, 0})));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_NEAR(area_of(d.pieces[0]), 3.14159265 * 300 * 150 / 2, 30);
  std::string through = groups({{0, "SPLINE"}, {8, "0"}, {70, "8"}, {71, "3"}});
  for (int i = 0; i <= 18; ++i)
    through += groups({{11, number(300 * std::cos(i * 0.17453292519943))},
                       {21, number(300 * std::sin(i * 0.17453292519943))}});
  const dxf::DxfDrawing fitted = read_trial(entities(through + line({-300, 0}, {300, 0})));
  ASSERT_EQ(fitted.pieces.size(), 1u);
  EXPECT_NEAR(area_of(fitted.pieces[0]), 3.14159265 * 300 * 300 / 2, 150);
}

TEST(DxfOutline, CurvesEndAtNotchesAndTurnPoints) {
  std::string body = groups({{0, "LWPOLYLINE"},
                             {8, "1"},
                             {70, "1"},
                             {10, "0"},
                             {20, "0"},
                             {10, "400"},
                             {20, "0"},
                             {42, "1"},
                             {10, "400"},
                             {20, "400"},
                             {10, "0"},
                             {20, "400"}});
  body += groups({{0, "POINT"}, {8, "4"}, {10, "600"}, {20, "200"}, {30, "-6.35"}, {39, "0"}, {50, "180"}});
  body += point({541.4213562, 341.4213562}, "2") + point({200, 0}, "4");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"A", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  const pattern::Panel panel = panel_of(d.pieces[0]);
  ASSERT_EQ(panel.notches.size(), 2u);
  EXPECT_NEAR(panel.notches[0].depth, 6.35, 1e-9);
  EXPECT_NEAR(panel.notches[0].inwards.x, -1, 1e-9);
  const auto ends_at = [&](Vec2 p) {
    for (const pattern::PanelEdge& edge : panel.outline.edges)
      for (const pattern::CubicBezier& c : edge.curves)
        if (length(c.p3 - p) < 0.05) return true;
    return false;
  };
  EXPECT_TRUE(ends_at({600, 200}));
  EXPECT_TRUE(ends_at({541.4213562, 341.4213562}));
  EXPECT_TRUE(ends_at({200, 0}));
  EXPECT_EQ(panel.outline.edges.size(), 2u) << "they part curves, not edges";
}

/// Half a shirt front: the fold along x = 0.
const std::string kHalf = polyline({{0, 0}, {250, 0}, {230, 400}, {100, 600}, {0, 520}}, "1");

TEST(DxfFold, AMirrorLineUnfoldsTheHalfWithItsMarks) {
  const std::string body = kHalf + line({0, 400}, {0, 50}, "6") + point({240, 200}, "4") +
                           point({0, 520}, "4") + rectangle({50, 100}, 20, 20, "11") +
                           line({30, 300}, {80, 300}, "8");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"FRONT", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  const dxf::DxfPiece& piece = d.pieces[0];
  EXPECT_TRUE(piece.unfolded);
  const double half =
      read_trial(entities(kHalf)).pieces.empty() ? 0 : area_of(read_trial(entities(kHalf)).pieces[0]);
  EXPECT_NEAR(area_of(piece), 2 * half, 1e-6);
  EXPECT_EQ(piece.notches.size(), 3u) << "one stands on the fold";
  EXPECT_EQ(piece.holes.size(), 2u);
  EXPECT_EQ(piece.internals.size(), 2u);
  const pattern::Panel panel = panel_of(piece);
  EXPECT_TRUE(pattern::validate(panel));
  EXPECT_EQ(panel.outline.edges.size(), 7u) << "the hem is one edge, sides, shoulders and neck are two each";
}

TEST(DxfFold, ALineThatEndsOnTheFoldGoesOnBehindIt) {
  const std::string body = kHalf + line({0, 520}, {0, 0}, "6") +
                           polyline({{0, 300}, {60, 300}, {80, 350}}, "8", 0) +
                           polyline({{70, 100}, {0, 90}}, "8", 0) + line({0, 40}, {0, 60}, "8") +
                           polyline({{0, 200}, {40, 200}, {40, 240}, {0, 240}}, "8", 0);
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"FRONT", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  ASSERT_EQ(d.pieces[0].internals.size(), 4u);
  EXPECT_EQ(d.pieces[0].internals[0],
            (std::vector<Vec2>{{-80, 350}, {-60, 300}, {0, 300}, {60, 300}, {80, 350}}));
  EXPECT_EQ(d.pieces[0].internals[1], (std::vector<Vec2>{{70, 100}, {0, 90}, {-70, 100}}));
  EXPECT_EQ(d.pieces[0].internals[2].size(), 2u) << "it lies in the fold";
  EXPECT_EQ(d.pieces[0].internals[3].size(), 7u) << "a pocket across the middle";
}

TEST(DxfFold, AFoldInTwoStretchesLeavesAHoleBetweenThem) {
  // A slit for a drawstring, half of it cut out of the fold.
  const std::string half =
      polyline({{0, 0}, {250, 0}, {230, 600}, {0, 600}, {0, 350}, {15, 350}, {15, 250}, {0, 250}}, "1");
  const std::string whole_line = line({0, 0}, {0, 600}, "6");
  const std::string two_lines = line({0, 350}, {0, 600}, "6") + line({0, 0}, {0, 250}, "6");
  for (const std::string& fold : {whole_line, two_lines}) {
    const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"FRONT", half + fold}}));
    ASSERT_EQ(d.pieces.size(), 1u);
    EXPECT_TRUE(d.pieces[0].unfolded);
    EXPECT_NEAR(area_of(d.pieces[0]), 480 * 600, 1e-6);
    ASSERT_EQ(d.pieces[0].holes.size(), 1u);
    EXPECT_NEAR(std::abs(geometry::signed_area(d.pieces[0].holes[0])), 30 * 100, 1e-6);
    EXPECT_TRUE(pattern::validate(panel_of(d.pieces[0])));
    EXPECT_TRUE(d.report.warnings.empty());
  }
}

TEST(DxfFold, APieceThatLiesOnBothSidesStaysAsItIs) {
  const dxf::DxfDrawing d = read_trial(
      blocks_and_inserts({{"YOKE", rectangle({-200, 0}, 400, 150, "1") + line({0, 0}, {0, 150}, "6")}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_FALSE(d.pieces[0].unfolded);
  EXPECT_TRUE(told(d, "a piece that is drawn whole"));
}

TEST(DxfFold, AMirrorLineAwayFromTheOutlineIsWarnedOf) {
  const dxf::DxfDrawing d = read_trial(
      blocks_and_inserts({{"YOKE", rectangle({20, 0}, 400, 150, "1") + line({0, 0}, {0, 150}, "6")}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_TRUE(told(d, "does not run along the outline"));
}

TEST(DxfFold, AMirrorLineBesideTheMiddleIsWarnedOf) {
  const auto with_line_at = [](double x) {
    const std::string yoke = rectangle({-200, 0}, 400, 150, "1") + line({x, 0}, {x, 150}, "6");
    return read_trial(blocks_and_inserts({{"YOKE", yoke}}));
  };
  EXPECT_TRUE(told(with_line_at(-180), "runs through the piece, and not through its middle"));
  EXPECT_FALSE(told(with_line_at(0), "not through its middle"));
}

TEST(DxfFold, ASewLineMayBeOpenAtTheFold) {
  const std::string sew = polyline({{0, 10}, {240, 10}, {220, 395}, {97, 586}, {0, 508}}, "14", 0);
  const dxf::DxfDrawing d =
      read_trial(blocks_and_inserts({{"FRONT", kHalf + sew + line({0, 0}, {0, 520}, "6")}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].layer, "14");
  EXPECT_TRUE(d.pieces[0].on_sew_line);
  EXPECT_TRUE(d.pieces[0].unfolded);
  EXPECT_TRUE(told(d, "gives way to the sew line"));
}

TEST(DxfFold, CutOnFoldWithoutAMirrorLineIsToldOf) {
  const dxf::DxfDrawing d =
      read_trial(blocks_and_inserts({{"FRONT", kHalf + text({50, 50}, "ANNOTATION: Cut 1 on fold", "1")}}));
  EXPECT_TRUE(told(d, "no mirror line says where"));
}

/// A graded file of two pieces in three sizes; texts stand on the sample size only.
std::string graded(bool sizes_as_texts, const std::string& sample = "Sample Size: 44") {
  std::string blocks, inserts;
  for (const std::string name : {"FR", "BK"}) {
    for (int size = 42; size <= 46; size += 2) {
      std::string body = open_sides({0, 0}, 200 + size, 600, "1") + line({50, 100}, {50, 300}, "7");
      if (sizes_as_texts) body += text({9, 9}, "SIZE: " + std::to_string(size), "1");
      if (size == 44)
        body += text({5, 5}, "Piece Name: " + name, "1") + text({5, 9}, "Quantity: 1,1", "1") +
                text({9, 40}, "Category: SELF", "1") + point({100, 0}, "4");
      blocks += block(name + "_" + std::to_string(size), body);
      inserts += insert(name + "_" + std::to_string(size), {0, 0});
    }
  }
  return section("BLOCKS", blocks) + entities(text({0, 0}, sample, "1") + inserts);
}

TEST(DxfGrading, TheSampleSizeIsTakenAndTheOthersAreListed) {
  for (const bool texts : {true, false}) {
    const dxf::DxfDrawing d = read_trial(graded(texts));
    ASSERT_EQ(d.pieces.size(), 2u) << texts;
    EXPECT_EQ(d.sizes, (std::vector<std::string>{"42", "44", "46"}));
    EXPECT_EQ(d.size, "44");
    EXPECT_EQ(d.pieces[0].name, "FR");
    EXPECT_EQ(d.pieces[0].size, "44");
    EXPECT_EQ(d.pieces[0].quantity, 2);
    EXPECT_EQ(d.pieces[0].mirrored, 1);
    EXPECT_NEAR(area_of(d.pieces[0]), 244 * 600, 1e-6);
    EXPECT_TRUE(told(d, "another size (46)"));
  }
}

TEST(DxfGrading, TheSizeAskedForIsTakenWithTheTextsOfTheSample) {
  dxf::DxfSettings settings;
  settings.size = "42";
  const dxf::DxfDrawing d = read_trial(graded(true), settings);
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_NEAR(area_of(d.pieces[0]), 242 * 600, 1e-6);
  EXPECT_EQ(d.pieces[0].quantity, 2);
  EXPECT_EQ(d.pieces[0].category, "SELF");
  EXPECT_EQ(d.pieces[1].size, "42");
  settings.size = "50";
  const auto none = dxf::read_dxf(graded(true), settings);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, "dxf.unknown_size");
  EXPECT_NE(none.error().message.find("42, 44, 46"), std::string::npos);
}

TEST(DxfGrading, WithoutASampleSizeTheOneWithTheTextsIsTaken) {
  const dxf::DxfDrawing d = read_trial(graded(true, "Author: somebody"));
  EXPECT_EQ(d.size, "44");
  EXPECT_TRUE(told(d, "no sample size"));
}

TEST(DxfGrading, PartsWithNumbersInTheirNamesAreNoSizes) {
  const std::string side = open_sides({0, 0}, 200, 600, "1");
  const dxf::DxfDrawing d =
      read_trial(blocks_and_inserts({{"SLEEVE_1", side}, {"SLEEVE_2", side}, {"POCKET", side}}));
  EXPECT_EQ(d.pieces.size(), 3u);
  EXPECT_TRUE(d.sizes.empty());
}

TEST(DxfGrading, LeftAndRightAndPartsThatLieApartAreNoSizes) {
  const auto shape = [](double x) { return rectangle({x, 0}, 300, 500, "1"); };
  EXPECT_EQ(read_trial(blocks_and_inserts(
                           {{"FR_L", shape(0)}, {"FR_R", shape(0)}, {"BK_L", shape(0)}, {"BK_R", shape(0)}}))
                .pieces.size(),
            4u);
  EXPECT_EQ(
      read_trial(blocks_and_inserts(
                     {{"FR_1", shape(0)}, {"FR_2", shape(400)}, {"BK_1", shape(800)}, {"BK_2", shape(1200)}}))
          .pieces.size(),
      4u);
  EXPECT_EQ(read_trial(blocks_and_inserts(
                           {{"FR-S", shape(0)}, {"FR-L", shape(5)}, {"BK-S", shape(0)}, {"BK-L", shape(5)}}))
                .pieces.size(),
            2u)
      << "sizes, behind a dash";
}

TEST(DxfGrading, WordsThatPiecesAreToldApartByAreNoSizes) {
  const auto shape = [](double x) { return rectangle({x, 0}, 300, 500, "1"); };
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts(
      {{"PRZOD_SR", shape(0)}, {"PRZOD_BOK", shape(5)}, {"TYL_SR", shape(0)}, {"TYL_BOK", shape(5)}}));
  EXPECT_EQ(d.pieces.size(), 4u);
  EXPECT_TRUE(d.sizes.empty());
}

TEST(DxfLayers, RepeatedLayersAreNoPieces) {
  const std::string body = rectangle({0, 0}, 300, 500, "1") + rectangle({0, 0}, 300, 500, "84") +
                           rectangle({10, 10}, 280, 480, "14") + rectangle({10, 10}, 280, 480, "87") +
                           line({50, 50}, {90, 90}, "8") + line({50, 50}, {90, 90}, "85");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"A", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].layer, "14");
  EXPECT_EQ(d.pieces[0].internals.size(), 1u);
  EXPECT_TRUE(told(d, "repeats another layer"));
  const dxf::DxfDrawing alone = read_trial(blocks_and_inserts({{"A", rectangle({0, 0}, 300, 500, "84")}}));
  EXPECT_EQ(alone.pieces.size(), 1u) << "where there is nothing else it is the outline";
}

TEST(DxfLayers, ASewLineMayStandOnLayerEight) {
  const std::string body = rectangle({0, 0}, 300, 500, "1") + rectangle({10, 10}, 280, 480, "8") +
                           rectangle({100, 300}, 100, 120, "8");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"A", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].layer, "8");
  EXPECT_NEAR(area_of(d.pieces[0]), 280 * 480, 1e-6);
  EXPECT_TRUE(d.pieces[0].on_sew_line);
  EXPECT_EQ(d.pieces[0].internals.size(), 1u) << "the pocket's place is no sew line";
}

TEST(DxfLayers, EverythingOnLayerZeroWithNestedOutlinesAndHundredsOfLabels) {
  std::string body;
  for (int piece = 0; piece < 3; ++piece) {
    const double x = piece * 500;
    body +=
        rectangle({x, 0}, 300, 500) + rectangle({x + 10, 10}, 280, 480) + rectangle({x + 100, 200}, 40, 40);
    for (int i = 0; i < 150; ++i) body += text({x + 20 + i, 50.0 + i}, std::to_string(i));
    body += groups({{0, "TEXT"},
                    {8, "0"},
                    {10, number(x + 90)},
                    {20, "90"},
                    {40, "12"},
                    {1, piece == 0   ? "FRONT"
                        : piece == 1 ? "BACK"
                                     : "SLEEVE"}});
  }
  const dxf::DxfDrawing d = read_trial(entities(body));
  ASSERT_EQ(d.pieces.size(), 3u);
  EXPECT_EQ(d.pieces[0].name, "FRONT");
  EXPECT_EQ(d.pieces[2].name, "SLEEVE");
  for (const dxf::DxfPiece& piece : d.pieces) {
    EXPECT_NEAR(std::abs(geometry::signed_area(piece.outline)), 280 * 480, 1e-6) << piece.name;
    EXPECT_EQ(piece.holes.size(), 1u) << piece.name;
  }
}

TEST(DxfLayers, NamesOfLayersAreUnderstoodToo) {
  const std::string body = rectangle({0, 0}, 300, 500, "CUT") + rectangle({10, 10}, 280, 480, "Sew Line") +
                           line({100, 100}, {100, 300}, "GRAINLINE") +
                           line({300, 250}, {294, 250}, "Notches");
  const dxf::DxfDrawing d = read_trial(entities(body));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].layer, "Sew Line");
  EXPECT_EQ(d.pieces[0].grain, (Vec2{0, 1}));
  ASSERT_EQ(d.pieces[0].notches.size(), 1u);
  EXPECT_NEAR(panel_of(d.pieces[0]).notches[0].at.x, 290, 1e-9) << "moved to the sew line";
  const dxf::DxfDrawing numbered = read_trial(
      entities(rectangle({0, 0}, 300, 500, "LAYER_01") + rectangle({10, 10}, 280, 480, "layer 14")));
  EXPECT_EQ(numbered.pieces.size(), 1u);
}

dxf::DxfPiece with_text(const std::string& words) {
  const dxf::DxfDrawing d = read_trial(
      blocks_and_inserts({{"BLOCKNAME", rectangle({0, 0}, 300, 500, "1") + text({9, 9}, words, "1")}}));
  return d.pieces.empty() ? dxf::DxfPiece{} : d.pieces[0];
}

TEST(DxfText, KeysComeInAnyCaseAndWithoutTheBlank) {
  for (const std::string words :
       {"Piece Name: Front", "PIECE NAME:Front", "piece name : Front", "Piece_Name:  Front"})
    EXPECT_EQ(with_text(words).name, "Front") << words;
  EXPECT_EQ(with_text("MATERIAL:Denim").material, "Denim");
}

TEST(DxfText, QuantitiesComeAsNumbersAndPairs) {
  const std::initializer_list<std::tuple<std::string, int, int>> cases{
      {"Quantity: 2", 2, 1},    {"QUANTITY:1,1", 2, 1},     {"Quantity: 1,0", 1, 0},  {"Quantity: 0", 1, 0},
      {"Quantity: 2, 2", 4, 2}, {"quantity: many", 1, 0},   {"Quantity: 2,0", 2, 0},  {"Quantity: 3", 3, 1},
      {"Quantity: 2.0", 2, 1},  {"Quantity: 1 pair", 2, 1}, {"Quantity: 4 pcs", 4, 2}};
  for (const auto& [words, quantity, mirrored] : cases) {
    EXPECT_EQ(with_text(words).quantity, quantity) << words;
    EXPECT_EQ(with_text(words).mirrored, mirrored) << words;
  }
}

TEST(DxfText, WhatIsCutTwiceOnTheFoldIsTwiceTheSame) {
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts(
      {{"COLLAR", kHalf + line({0, 0}, {0, 520}, "6") + text({50, 50}, "Quantity: 2", "1")}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].quantity, 2);
  EXPECT_EQ(d.pieces[0].mirrored, 0);
}

TEST(DxfText, ChineseWithoutADeclarationIsReadAndLostLettersAreNot) {
  EXPECT_EQ(with_text("Piece Name: \xC7\xB0\xC6\xAC").name, "\xE5\x89\x8D\xE7\x89\x87") << "GBK";
  EXPECT_EQ(with_text("Piece Name: \xE5\x89\x8D\xE7\x89\x87").name, "\xE5\x89\x8D\xE7\x89\x87") << "UTF-8";
  EXPECT_EQ(with_text("Piece Name: \xC4rmel").name, "\xC3\x84rmel") << "Latin 1";
  EXPECT_EQ(with_text("Piece Name: ???????").name, "BLOCKNAME");
  const std::string lost = rectangle({0, 0}, 300, 500, "1") + text({9, 9}, "PIECE NAME: ????", "1");
  EXPECT_EQ(read_trial(blocks_and_inserts({{"????_M", lost}})).pieces.at(0).name, "????_M");
  EXPECT_EQ(read_trial(blocks_and_inserts({{"????", lost}})).pieces.at(0).name, "piece1");
}

TEST(DxfText, MtextAndAttributesNamePieces) {
  const std::string mtext = groups({{0, "MTEXT"},
                                    {8, "0"},
                                    {10, "50"},
                                    {20, "50"},
                                    {40, "9"},
                                    {1, "{\\fArial|b0|i0;Piece Name: }\\H2x;Back"}});
  const dxf::DxfDrawing d = read_trial(entities(rectangle({0, 0}, 300, 500) + mtext));
  EXPECT_EQ(d.pieces.at(0).name, "Back");
}

}  // namespace
}  // namespace toile
