#include "core/pattern/dxf/read.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"
#include "core/pattern/validate.h"
#include "tests/core/pattern/dxf/dxf_text.h"

namespace toile {
namespace {

using namespace dxf_text;

dxf::DxfDrawing read(const std::string& text, const dxf::DxfSettings& settings = in_mm()) {
  Result<dxf::DxfDrawing> drawing = dxf::read_dxf(text, settings);
  if (!drawing) {
    ADD_FAILURE() << to_string(drawing.error());
    return {};
  }
  return *drawing;
}

double area(const dxf::DxfPiece& piece) { return std::abs(geometry::signed_area(piece.outline)); }

/// Whether a warning or the reason of any entity has these words.
bool noted(const dxf::DxfDrawing& drawing, const std::string& words) {
  const auto has = [&](const std::string& text) { return text.find(words) != std::string::npos; };
  return std::any_of(drawing.notes.begin(), drawing.notes.end(), has) ||
         std::any_of(drawing.report.groups.begin(), drawing.report.groups.end(),
                     [&](const dxf::DxfEntityGroup& g) { return has(g.reason); });
}

TEST(DxfRead, AClosedPolylineIsAPiece) {
  const dxf::DxfDrawing d = read(header(4) + entities(rectangle({10, 20}, 300, 200)));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].name, "piece1");
  EXPECT_EQ(d.pieces[0].line, 16);
  EXPECT_EQ(d.pieces[0].outline.size(), 4u);
  EXPECT_EQ(d.pieces[0].outline[0], (Vec2{10, 20}));
  EXPECT_TRUE(d.notes.empty());
}

TEST(DxfRead, WindowsAndOldMacLineEndsAndABomAndBlanksReadAlike) {
  const std::string unix_text = entities(rectangle({0, 0}, 30, 20));
  for (const std::string end : {"\r\n", "\r", "  \n"}) {
    std::string text = "\xEF\xBB\xBF";
    for (char c : unix_text) text += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(read(text).pieces.size(), 1u);
  }
  std::istringstream stream(unix_text);
  EXPECT_TRUE(dxf::read_dxf(stream, in_mm()).ok());
}

TEST(DxfRead, ChainsOpenLinesIntoOneOutlineInAnyOrderAndDirection) {
  // A pentagon of single lines, shuffled, some turned, joints up to 0.08 mm apart.
  const dxf::DxfDrawing d =
      read(entities(line({100, 0}, {0, 0}) + line({0, 100}, {50, 150}) + line({100, 100}, {100, 0.08}) +
                    line({0.05, 0}, {0, 100}) + line({50, 150.05}, {100, 100})));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].outline.size(), 5u);
  EXPECT_EQ(d.pieces[0].breaks.size(), 5u);
  EXPECT_NEAR(area(d.pieces[0]), 12'500, 20);
  EXPECT_EQ(d.pieces[0].line, 6);
}

TEST(DxfRead, OpenPolylinesThatReturnToTheirStartAreClosed) {
  const dxf::DxfDrawing d = read(entities(polyline({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0.05}}, "0", 0)));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].outline.size(), 4u);
}

TEST(DxfRead, LinesOfDifferentLayersAreNotChained) {
  const auto d = dxf::read_dxf(
      entities(line({0, 0}, {10, 0}, "a") + line({10, 0}, {0, 10}, "b") + line({0, 10}, {0, 0}, "a")),
      in_mm());
  ASSERT_FALSE(d);
  EXPECT_EQ(d.error().code, "dxf.open_outline");
}

TEST(DxfRead, BulgesBecomeArcsOfTheRightSideAndSize) {
  // A square whose right side is a half circle outwards (bulge 1, counter-clockwise outline).
  const std::string body = groups({{0, "LWPOLYLINE"},
                                   {8, "0"},
                                   {90, "4"},
                                   {70, "1"},
                                   {10, "0"},
                                   {20, "0"},
                                   {10, "100"},
                                   {20, "0"},
                                   {42, "1"},
                                   {10, "100"},
                                   {20, "100"},
                                   {10, "0"},
                                   {20, "100"}});
  EXPECT_NEAR(area(read(entities(body)).pieces[0]), 10'000 + kPi * 2500 / 2, 5);
  std::string inwards = body;
  inwards.replace(inwards.find("42\n1\n"), 5, "42\n-1\n");
  EXPECT_NEAR(area(read(entities(inwards)).pieces[0]), 10'000 - kPi * 2500 / 2, 5);
  const std::string old = groups({{0, "POLYLINE"},
                                  {8, "0"},
                                  {66, "1"},
                                  {70, "1"},
                                  {0, "VERTEX"},
                                  {10, "0"},
                                  {20, "0"},
                                  {42, "1"},
                                  {0, "VERTEX"},
                                  {10, "80"},
                                  {20, "0"},
                                  {42, "1"},
                                  {0, "SEQEND"}});
  EXPECT_NEAR(area(read(entities(old)).pieces[0]), kPi * 1600, 5) << "two half circles";
}

TEST(DxfRead, ArcsAndCirclesAndLinesMakeOutlines) {
  const std::string cap =
      groups({{0, "ARC"}, {8, "0"}, {10, "50"}, {20, "100"}, {40, "50"}, {50, "0"}, {51, "180"}});
  const dxf::DxfDrawing d =
      read(entities(line({0, 0}, {100, 0}) + line({100, 0}, {100, 100}) + cap + line({0, 100}, {0, 0})));
  EXPECT_NEAR(area(d.pieces[0]), 10'000 + kPi * 1250, 5);
  const std::string circle = groups({{0, "CIRCLE"}, {8, "0"}, {10, "5"}, {20, "5"}, {40, "30"}});
  const dxf::DxfDrawing round = read(entities(circle));
  EXPECT_NEAR(area(round.pieces[0]), kPi * 900, 3);
  const auto panel = dxf::panel_from_piece(round.pieces[0]);
  ASSERT_TRUE(panel);
  EXPECT_EQ(panel->outline.edges.size(), 1u);
}

TEST(DxfRead, MirroredPlanesTurnPiecesOver) {
  const std::string body = groups({{0, "LWPOLYLINE"},
                                   {8, "0"},
                                   {70, "1"},
                                   {10, "10"},
                                   {20, "0"},
                                   {10, "30"},
                                   {20, "0"},
                                   {10, "10"},
                                   {20, "40"},
                                   {230, "-1"}});
  EXPECT_EQ(read(entities(body)).pieces[0].outline[1], (Vec2{-30, 0}));
}

TEST(DxfRead, WhereTwoArcsMeetAtAnAngleAnEdgeEnds) {
  // A pointed arch over a line of 200: its arcs turn by `degrees` at the top.
  const auto edges = [](double degrees) {
    const double slope = std::tan(degrees / 2 * kPi / 180);
    const double height = 100 * (slope + std::sqrt(slope * slope + 1)), off = slope * height;
    const double radius = 100 + off, top = std::atan2(height, off) * 180 / kPi;
    const auto arc = [&](double x, double from, double to) {
      return groups({{0, "ARC"},
                     {8, "0"},
                     {10, number(x)},
                     {20, "0"},
                     {40, number(radius)},
                     {50, number(from)},
                     {51, number(to)}});
    };
    const dxf::DxfDrawing d =
        read(entities(line({0, 0}, {200, 0}) + arc(100 - off, 0, top) + arc(100 + off, 180 - top, 180)));
    const auto panel = dxf::panel_from_piece(d.pieces.at(0));
    return panel ? panel->outline.edges.size() : 0;
  };
  EXPECT_EQ(edges(30), 3u) << "less than what counts as a corner of a polyline";
  EXPECT_EQ(edges(10), 2u);
}

TEST(DxfRead, SplinesFollowTheirControlPointsAndWeights) {
  // A quarter circle of radius 100 as a rational quadratic, closed by two lines.
  const std::string spline = groups({{0, "SPLINE"}, {8, "0"},
                                     {70, "4"},     {71, "2"},
                                     {72, "6"},     {73, "3"},
                                     {40, "0"},     {40, "0"},
                                     {40, "0"},     {40, "1"},
                                     {40, "1"},     {40, "1"},
                                     {41, "1"},     {41, "0.70710678118654752"},
                                     {41, "1"},     {10, "100"},
                                     {20, "0"},     {10, "100"},
                                     {20, "100"},   {10, "0"},
                                     {20, "100"}});
  const dxf::DxfDrawing d = read(entities(line({0, 0}, {100, 0}) + spline + line({0, 100}, {0, 0})));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_NEAR(area(d.pieces[0]), kPi * 2500, 2);
  std::string without = spline;
  without.replace(without.find("71\n2\n"), 5, "71\n9\n");
  const auto open =
      dxf::read_dxf(entities(line({0, 0}, {100, 0}) + without + line({0, 100}, {0, 0})), in_mm());
  EXPECT_EQ(open.error().code, "dxf.open_outline");
}

TEST(DxfRead, LoopsWithinALoopOfTheSameLayerAreHoles) {
  const dxf::DxfDrawing d =
      read(entities(rectangle({20, 20}, 10, 10) + rectangle({0, 0}, 100, 100) + rectangle({60, 60}, 30, 30) +
                    rectangle({70, 70}, 5, 5) + rectangle({40, 40}, 10, 10, "marks")));
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_EQ(d.pieces[0].holes.size(), 2u);
  EXPECT_TRUE(noted(d, "cut out as a hole"));
  EXPECT_EQ(d.pieces[1].outline[0], (Vec2{70, 70})) << "a piece cut from the waste of a hole";
  EXPECT_TRUE(noted(d, "within a piece of another layer"));
  const auto panel = dxf::panel_from_piece(d.pieces[0]);
  ASSERT_TRUE(panel);
  EXPECT_EQ(panel->holes[1].edges[0].id, "h1e0");
  EXPECT_TRUE(pattern::validate(*panel)) << "outline counter-clockwise, holes clockwise";
}

TEST(DxfRead, OverlappingPiecesStayPiecesAndRepeatedOnesAreReadOnce) {
  EXPECT_EQ(read(entities(rectangle({0, 0}, 100, 100) + rectangle({50, 50}, 90, 90))).pieces.size(), 2u);
  const dxf::DxfDrawing twice =
      read(entities(rectangle({0, 0}, 100, 100) + rectangle({0, 0}, 100, 100, "copy")));
  EXPECT_EQ(twice.pieces.size(), 1u);
  EXPECT_TRUE(noted(twice, "drawn a second time"));
}

TEST(DxfRead, StatementsAreReadInOtherLanguages) {
  const std::string piece =
      block("B1", text({50, 50}, "PARCA: KOL") + text({50, 60}, "BEDEN: 42") + text({50, 70}, "ADET: 1,1") +
                      text({50, 80}, "2 ADET (AYNALI)") + rectangle({0, 0}, 300, 400, "1"));
  const dxf::DxfDrawing d = read(section("BLOCKS", piece) + entities(insert("B1", {0, 0})));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].name, "KOL");
  EXPECT_EQ(d.pieces[0].size, "42");
  EXPECT_EQ(d.pieces[0].quantity, 2);
  EXPECT_EQ(d.pieces[0].mirrored, 1);
  const std::string german = block("B1", text({50, 50}, "Teilename: \xc3\x84rmel") +
                                             text({50, 70},
                                                  "St\xc3\xbc"
                                                  "ck: 2") +
                                             rectangle({0, 0}, 300, 400, "1"));
  const dxf::DxfDrawing other = read(section("BLOCKS", german) + entities(insert("B1", {0, 0})));
  ASSERT_EQ(other.pieces.size(), 1u);
  EXPECT_EQ(other.pieces[0].name, "\xc3\x84rmel");
  EXPECT_EQ(other.pieces[0].quantity, 2);
}

TEST(DxfRead, ANameAloneIsAPiecesNameToo) {
  for (const char* key : {"NOME", "Nom", "Name", "Bezeichnung"}) {
    const std::string piece = block("P01", text({50, 50}, std::string(key) + ": FRENTE") +
                                               text({50, 60}, "TAM: 40") + rectangle({0, 0}, 300, 400, "1"));
    const dxf::DxfDrawing d = read(section("BLOCKS", piece) + entities(insert("P01", {0, 0})));
    ASSERT_EQ(d.pieces.size(), 1u);
    EXPECT_EQ(d.pieces[0].name, "FRENTE") << key;
    EXPECT_EQ(d.pieces[0].size, "40");
  }
}

TEST(DxfRead, AamaBlocksArePiecesWithTheirNamesGrainAndInserts) {
  const std::string front =
      block("front_M", text({50, 50}, "Piece Name: Front") + text({50, 50}, "Size: M") +
                           rectangle({0, 0}, 100, 200, "1") + line({50, 150}, {50, 50}, "7") +
                           line({10, 10}, {20, 20}, "8") + rectangle({30, 30}, 5, 5, "11"));
  const std::string back = block("back_M", rectangle({0, 0}, 110, 200, "1"), {10, 0});
  const std::string text_of = section("BLOCKS", front + back) +
                              entities(insert("front_M", {0, 0}) + insert("back_M", {500, 0}) +
                                       insert("front_M", {0, 900}) + text({0, -60}, "Style Name: test"));
  const dxf::DxfDrawing d = read(text_of);
  ASSERT_EQ(d.pieces.size(), 3u);
  EXPECT_EQ(d.pieces[0].name, "Front");
  EXPECT_EQ(d.pieces[1].name, "back_M");
  EXPECT_EQ(d.pieces[2].name, "Front-2");
  EXPECT_EQ(d.pieces[0].grain, (Vec2{0, 1}));
  EXPECT_EQ(d.pieces[0].holes.size(), 1u);
  EXPECT_EQ(d.pieces[1].outline[0], (Vec2{490, 0})) << "insert minus base";
  EXPECT_EQ(d.pieces[2].outline[0], (Vec2{0, 900}));
  EXPECT_EQ(d.pieces[0].internals.size(), 1u);
  const auto missing = dxf::read_dxf(entities(insert("sleeve", {0, 0})), in_mm());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, "dxf.unknown_block");
  const dxf::DxfDrawing left_over = read(section("BLOCKS", front) + entities(insert("sleeve", {0, 0})));
  EXPECT_EQ(left_over.pieces.size(), 1u);
  EXPECT_TRUE(noted(left_over, "'sleeve', which the file does not hold"));
}

TEST(DxfRead, BlocksWithoutInsertsAreOnePieceEach) {
  const std::string blocks = block("*Model_Space", "") + block("a", rectangle({0, 0}, 9, 9, "1")) +
                             block("b", rectangle({0, 0}, 8, 8, "1"));
  const dxf::DxfDrawing d = read(section("BLOCKS", blocks) + entities(""));
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_EQ(d.pieces[1].name, "b");
}

TEST(DxfRead, InsertsTurnScaleAndMirror) {
  const std::string turned =
      groups({{0, "INSERT"}, {2, "a"}, {10, "100"}, {20, "0"}, {41, "2"}, {42, "3"}, {50, "90"}});
  const dxf::DxfDrawing d = read(section("BLOCKS", block("a", rectangle({0, 0}, 10, 20))) + entities(turned));
  EXPECT_EQ(d.pieces[0].outline[1], (Vec2{100, 20}));
  EXPECT_EQ(d.pieces[0].outline[3], (Vec2{40, 0}));
}

TEST(DxfRead, TheSewLineIsTakenBeforeTheCutLine) {
  const std::string both = rectangle({0, 0}, 120, 120, "1") + rectangle({10, 10}, 100, 100, "14") +
                           rectangle({300, 0}, 50, 50, "1");
  const dxf::DxfDrawing d = read(entities(both));
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_EQ(d.pieces[0].layer, "14");
  EXPECT_EQ(d.pieces[1].layer, "1") << "a piece with a cut line only";
  EXPECT_TRUE(noted(d, "gives way to the sew line"));
  const std::string open =
      rectangle({0, 0}, 120, 120, "1") + line({10, 10}, {110, 10}, "14") + line({110, 10}, {110, 110}, "14");
  EXPECT_EQ(read(entities(open)).pieces[0].layer, "1") << "the sew line does not close";
}

TEST(DxfRead, TextsNameTheNearestPiece) {
  const std::string pieces = rectangle({0, 0}, 100, 100) + rectangle({140, 0}, 100, 100) +
                             rectangle({280, 0}, 100, 100) + rectangle({420, 0}, 100, 100);
  for (const double mm_per_unit : {1.0, 25.4}) {
    dxf::DxfSettings settings = in_mm();
    settings.mm_per_unit = mm_per_unit;
    const dxf::DxfDrawing d = read(
        entities(pieces + text({0, -15}, "skirt_back") + text({190, 50}, "front") +
                 text({280, -45}, "too far") + text({450, 50}, "front") + text({450, 60}, "Cut by: hand")),
        settings);
    ASSERT_EQ(d.pieces.size(), 4u);
    EXPECT_EQ(d.pieces[0].name, "skirt_back");
    EXPECT_EQ(d.pieces[1].name, "front");
    EXPECT_EQ(d.pieces[2].name, "piece3");
    EXPECT_EQ(d.pieces[3].name, "front-2");
  }
}

TEST(DxfRead, NamesAreCleanUtf8) {
  EXPECT_EQ(read(entities(rectangle({0, 0}, 9, 9) + text({4, 4}, "\xC4rmel"))).pieces[0].name,
            "\xC3\x84rmel");
  EXPECT_EQ(
      read(entities(rectangle({0, 0}, 9, 9) + text({4, 4}, "\xC3\x84rmel \\U+00E9\x01"))).pieces[0].name,
      "\xC3\x84rmel \xC3\xA9");
}

TEST(DxfRead, ForcedCornersAndBreaksReachThePanel) {
  const dxf::DxfDrawing d = read(entities(line({0, 0}, {50, 0}) + line({50, 0}, {100, 0}) +
                                          line({100, 0}, {0, 90}) + line({0, 90}, {0, 0})));
  EXPECT_EQ(dxf::panel_from_piece(d.pieces[0])->outline.edges.size(), 3u);
  EXPECT_EQ(dxf::panel_from_piece(d.pieces[0], d.pieces[0].breaks)->outline.edges.size(), 4u);
  EXPECT_EQ(dxf::panel_from_piece(d.pieces[0], std::vector<Vec2>{{7, 7}}).error().where,
            "piece piece1, corner 0");
}

TEST(DxfRead, EntitiesThatFaredAlikeAreToldTogetherWithTheirLines) {
  std::string points;
  for (int i = 0; i < 50; ++i) points += groups({{0, "POINT"}, {8, "2"}, {10, "1"}, {20, "1"}});
  const dxf::DxfDrawing d =
      read(entities(rectangle({0, 0}, 9, 9) + points + groups({{0, "HATCH"}, {8, "0"}})));
  const auto of = [&](const std::string& type) {
    return *std::find_if(d.report.groups.begin(), d.report.groups.end(),
                         [&](const dxf::DxfEntityGroup& g) { return g.type == type; });
  };
  EXPECT_EQ(of("POINT").lines.size(), 50u);
  EXPECT_EQ(of("POINT").lines[1] - of("POINT").lines[0], 8);
  EXPECT_EQ(of("HATCH").reason, "HATCH makes no outline");
  EXPECT_EQ(d.report.entities, 52u);
  EXPECT_EQ(d.report.kept, 1u);
  EXPECT_EQ(d.report.dropped, 51u);
}

}  // namespace
}  // namespace toile
