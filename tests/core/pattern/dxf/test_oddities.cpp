// What stands in pattern systems' files beside a plain outline: releases, entities of every kind, layers,
// keys.

#include <array>
#include <numeric>

#include "core/pattern/validate.h"
#include "tests/core/pattern/dxf/dxf_trial.h"

namespace toile {
namespace {

using namespace dxf_text;

constexpr double kPi = 3.14159265358979323846;

/// A rectangle as the releases since R13 write it: handles, owners and class names between the figures.
std::string newer_rectangle(double width, double height) {
  std::string out = groups({{0, "LWPOLYLINE"},
                            {5, "2F"},
                            {102, "{ACAD_REACTORS"},
                            {330, "1F"},
                            {102, "}"},
                            {330, "1F"},
                            {100, "AcDbEntity"},
                            {8, "1"},
                            {6, "ByLayer"},
                            {62, "256"},
                            {370, "-1"},
                            {100, "AcDbPolyline"},
                            {90, "4"},
                            {70, "1"},
                            {43, "0.0"}});
  for (const Vec2 p : {Vec2{0, 0}, Vec2{width, 0}, Vec2{width, height}, Vec2{0, height}})
    out += groups({{10, number(p.x)}, {20, number(p.y)}, {91, "0"}});
  return out;
}

std::string version(const std::string& release, int units) {
  std::string body = groups({{9, "$ACADVER"}, {1, release}});
  if (units > 0) body += groups({{9, "$INSUNITS"}, {70, std::to_string(units)}});
  return section("HEADER", body);
}

TEST(DxfStructure, FilesOfTheOldestAndTheNewestReleaseReadAlike) {
  const std::string tables = section("TABLES", groups({{0, "TABLE"},
                                                       {2, "LAYER"},
                                                       {70, "1"},
                                                       {0, "LAYER"},
                                                       {2, "1"},
                                                       {70, "0"},
                                                       {62, "7"},
                                                       {6, "CONTINUOUS"},
                                                       {0, "ENDTAB"}}));
  const std::string classes =
      section("CLASSES", groups({{0, "CLASS"}, {1, "ACDBDICTIONARYWDFLT"}, {2, "x"}}));
  const std::string objects = section("OBJECTS", groups({{0, "DICTIONARY"}, {5, "C"}, {330, "0"}}));
  const std::string newest = version("AC1027", 4) + classes + tables +
                             section("BLOCKS", block("*Model_Space", "") + block("*Paper_Space", "")) +
                             section("ENTITIES", newer_rectangle(300, 500)) + objects + groups({{0, "EOF"}});
  const std::string oldest = version("AC1006", 0) + entities(rectangle({0, 0}, 300, 500, "1"));
  for (const std::string& text : {oldest, version("AC1009", 0) + tables + oldest, newest}) {
    const dxf::DxfDrawing d = read_trial(text);
    ASSERT_EQ(d.pieces.size(), 1u);
    EXPECT_EQ(d.unit.name, "mm");
    EXPECT_NEAR(area_of(d.pieces[0]), 150'000, 1e-6);
    EXPECT_TRUE(d.report.warnings.empty());
  }
  EXPECT_GT(read_trial(newest).report.elsewhere, 0u) << "layers, classes and objects are no drawing";
}

/// A piece of four kinds of entities: a line at the bottom, half a circle at the right, a line of two bulges
/// at the top, a spline at the left; each in one direction or the other.
std::array<std::string, 4> four_kinds(unsigned turned) {
  const auto is = [&](unsigned bit) { return (turned & bit) != 0; };
  const Vec2 a{0, 0}, b{400, 0}, c{400, 300}, d{0, 300}, top{200, 300};
  const std::string bottom = is(1) ? line(b, a, "1") : line(a, b, "1");
  // Arcs run counter-clockwise; seen from behind they run the other way.
  std::string right = groups({{0, "ARC"}, {8, "1"}, {10, is(2) ? "-400" : "400"}, {20, "150"}, {40, "150"}});
  right += is(2) ? groups({{50, "90"}, {51, "270"}, {230, "-1"}}) : groups({{50, "270"}, {51, "90"}});
  std::string upper = groups({{0, "LWPOLYLINE"}, {8, "1"}, {70, "0"}});
  for (const Vec2 p : is(4) ? std::array{d, top, c} : std::array{c, top, d})
    upper += groups({{10, number(p.x)}, {20, number(p.y)}, {42, is(4) ? "-0.5" : "0.5"}});
  std::string left = groups({{0, "SPLINE"}, {8, "1"}, {70, "8"}, {71, "3"}});
  for (const char* knot : {"0", "0", "0", "0", "1", "1", "1", "1"}) left += groups({{40, knot}});
  std::vector<Vec2> controls{d, {-120, 200}, {-120, 100}, a};
  if (is(8)) std::reverse(controls.begin(), controls.end());
  for (const Vec2 p : controls) left += groups({{10, number(p.x)}, {20, number(p.y)}});
  return {bottom, right, upper, left};
}

TEST(DxfOutline, LinesArcsBulgesAndSplinesMeetInAnyOrderAndDirection) {
  // An arc of bulge 1/2 over a chord of 200: radius 125, 4 atan(1/2) of the circle.
  const double angle = 4 * std::atan(0.5), segment = 125 * 125 * (angle - std::sin(angle)) / 2;
  const double expected = 400 * 300 + kPi * 150 * 150 / 2 + 2 * segment + 0.6 * 120 * 300 * 0.75;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  double first = 0;
  do {
    for (unsigned turned = 0; turned < 16; ++turned) {
      const std::array<std::string, 4> parts = four_kinds(turned);
      std::string body;
      for (const std::size_t i : order) body += parts[i];
      const dxf::DxfDrawing d = read_trial(header(4) + entities(body));
      ASSERT_EQ(d.pieces.size(), 1u) << turned;
      if (first == 0) first = area_of(d.pieces[0]);
      ASSERT_NEAR(area_of(d.pieces[0]), first, 1) << turned;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_NEAR(first, expected, 0.05 * expected);
}

TEST(DxfLayers, EveryLayerMeansWhatItsNumberSays) {
  const std::string circle = groups({{0, "CIRCLE"}, {8, "13"}, {10, "60"}, {20, "400"}, {40, "3"}});
  const std::string body = rectangle({0, 0}, 300, 500, "1") + point({0, 0}, "2") + point({150, 0}, "3") +
                           point({300, 100}, "4") + point({300, 500}, "5") +
                           line({250, 100}, {50, 100}, "7") + line({50, 50}, {90, 90}, "8") +
                           line({0, 250}, {300, 250}, "9") + rectangle({100, 300}, 40, 60, "11") +
                           point({200, 400}, "13") + circle + text({20, 20}, "Piece Name: Front", "15");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"A", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  const dxf::DxfPiece& piece = d.pieces[0];
  EXPECT_EQ(piece.name, "Front");
  EXPECT_FALSE(piece.on_sew_line);
  EXPECT_EQ(piece.turn_points.size(), 1u);
  EXPECT_EQ(piece.notches.size(), 1u);
  EXPECT_EQ(piece.grain, (Vec2{1, 0})) << "along x";
  EXPECT_EQ(piece.internals.size(), 1u);
  EXPECT_EQ(piece.holes.size(), 1u);
  EXPECT_EQ(piece.drills.size(), 2u) << "a point and a little circle";
  EXPECT_TRUE(told(d, "curve point"));
  EXPECT_TRUE(told(d, "grade point"));
  EXPECT_TRUE(told(d, "stripes or plaids"));
}

TEST(DxfOutline, EdgesOfATenThousandthOfAnInchVanishWithoutATrace) {
  const double tiny = 1e-4;
  const std::string body = polyline({{0, 0}, {20, 0}}, "1", 0) + polyline({{20, 0}, {20, tiny}}, "1", 0) +
                           polyline({{20, tiny}, {20, 30}, {20 - tiny, 30}, {0, 30}}, "1", 0) +
                           polyline({{0, 30}, {0, tiny}, {0, 0}}, "1", 0);
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"A", body}}, text({0, 0}, "UNITS:ENGLISH", "1")));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.unit.name, "inch");
  const pattern::Panel panel = panel_of(d.pieces[0]);
  EXPECT_EQ(panel.outline.edges.size(), 4u);
  EXPECT_TRUE(pattern::validate(panel));
  EXPECT_NEAR(pattern::signed_area(panel.outline), 600 * 25.4 * 25.4, 5);
}

TEST(DxfText, EveryKeyIsKnownInAnyCaseWithOrWithoutABlank) {
  const auto in_style = [](int style, std::string key, const std::string& value) {
    for (char& c : key)
      c = static_cast<char>(style == 1   ? std::toupper(static_cast<unsigned char>(c))
                            : style == 2 ? std::tolower(static_cast<unsigned char>(c))
                                         : c);
    return key + (style == 0 ? ": " : style == 1 ? ":" : " : ") + value;
  };
  for (const int style : {0, 1, 2}) {
    std::string body = rectangle({0, 0}, 300, 500, "1");
    double y = 10;
    for (const auto& [key, value] :
         std::initializer_list<std::pair<const char*, const char*>>{{"Piece Name", "Front"},
                                                                    {"Size", "M"},
                                                                    {"Quantity", "1,1"},
                                                                    {"Material", "Denim"},
                                                                    {"Category", "Shell"},
                                                                    {"Annotation", "Cut pair"}})
      body += text({9, y += 12}, in_style(style, key, value), "1");
    const dxf::DxfDrawing d = read_trial(
        blocks_and_inserts({{"X1", body}}, text({0, 0}, in_style(style, "Style Name", "Jean 501"), "1") +
                                               text({0, 9}, in_style(style, "Sample Size", "M"), "1") +
                                               text({0, 18}, in_style(style, "Units", "Metric"), "1")));
    ASSERT_EQ(d.pieces.size(), 1u);
    const dxf::DxfPiece& piece = d.pieces[0];
    EXPECT_EQ(piece.name, "Front") << style;
    EXPECT_EQ(piece.quantity, 2) << style;
    EXPECT_EQ(piece.mirrored, 1) << style;
    EXPECT_EQ(piece.material, "Denim") << style;
    EXPECT_EQ(piece.category, "Shell") << style;
    EXPECT_EQ(piece.annotation, "Cut pair") << style;
    EXPECT_EQ(d.style, "Jean 501") << style;
    EXPECT_EQ(d.sample_size, "M") << style;
    EXPECT_EQ(d.unit.name, "mm") << style;
  }
}

TEST(DxfLayers, LinesWithinAPieceHaveALimitThatIsTold) {
  std::string body = rectangle({0, 0}, 600, 600, "1");
  for (int i = 0; i < 520; ++i) body += line({5, 1.0 + i}, {590, 1.5 + i}, "8");
  const dxf::DxfDrawing d = read_trial(blocks_and_inserts({{"A", body}}));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].internals.size(), 500u);
  EXPECT_TRUE(told(d, "takes 500 lines"));
}

TEST(DxfOutline, ASleeveCapIsTwoToSixCurvesHoweverFinelyItIsDrawn) {
  const std::array<pattern::CubicBezier, 4> cap{
      pattern::CubicBezier{{180, 0}, {150, 30}, {130, 40}, {110, 80}},
      pattern::CubicBezier{{110, 80}, {85, 130}, {50, 150}, {0, 150}},
      pattern::CubicBezier{{0, 150}, {-55, 150}, {-95, 125}, {-118, 75}},
      pattern::CubicBezier{{-118, 75}, {-135, 38}, {-150, 20}, {-185, 0}}};
  for (const int steps : {7, 10, 20, 100}) {
    std::string out = groups({{0, "LWPOLYLINE"}, {8, "1"}, {70, "1"}});
    const auto vertex = [&](Vec2 p) { out += groups({{10, number(p.x)}, {20, number(p.y)}}); };
    vertex({-150, -400});
    vertex({150, -400});
    for (const pattern::CubicBezier& c : cap)
      for (int i = c.p0.x == 180 ? 0 : 1; i <= steps; ++i) vertex(pattern::evaluate(c, double(i) / steps));
    const dxf::DxfDrawing d = read_trial(header(4) + entities(out));
    ASSERT_EQ(d.pieces.size(), 1u);
    const pattern::Panel panel = panel_of(d.pieces[0]);
    ASSERT_EQ(panel.outline.edges.size(), 4u) << steps;
    std::size_t most = 0;
    for (const pattern::PanelEdge& edge : panel.outline.edges) most = std::max(most, edge.curves.size());
    EXPECT_GE(most, 2u) << steps;
    EXPECT_LE(most, 6u) << steps;
  }
}

}  // namespace
}  // namespace toile
