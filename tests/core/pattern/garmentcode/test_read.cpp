// Specifications as GarmentCode writes them, right and wrong.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/base/units.h"
#include "core/json/tree.h"
#include "core/pattern/curve.h"
#include "core/pattern/garmentcode/curves.h"
#include "core/pattern/garmentcode/read.h"
#include "core/pattern/validate.h"
#include "core/sewing/placement.h"

namespace toile {
namespace {

/// A square of `side` units with `edges` in place of its edge list, and `more` after the panels.
std::string square(const std::string& edges, const std::string& more = "",
                   const std::string& properties = "") {
  return R"({"pattern": {"panels": {"front": {"translation": [1, 2, 3], "rotation": [0, 0, 90],
    "vertices": [[0, 0], [10, 0], [10, 10], [0, 10]], "edges": [)" +
         edges + "]}}" + more + "}" + properties + "}";
}

const char* const kPlainEdges =
    R"({"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]})";

std::string with_first_edge(const std::string& curvature) {
  return square(R"({"endpoints": [0, 1], "curvature": )" + curvature +
                R"(}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]})");
}

Vec2 middle(const pattern::PanelEdge& edge) {
  return pattern::point_at_length(edge, pattern::arc_length(edge) / 2);
}

Error error_of(const std::string& text) {
  const auto read = garmentcode::read_garmentcode(text);
  EXPECT_FALSE(read.ok()) << text;
  return read ? Error{} : read.error();
}

TEST(GarmentCodeRead, CountsCentimetresUnlessTheFileSaysOtherwise) {
  const auto plain = garmentcode::read_garmentcode(square(kPlainEdges));
  ASSERT_TRUE(plain.ok()) << to_string(plain.error());
  EXPECT_NEAR(pattern::arc_length(plain->pattern.panels[0].outline.edges[0]), 100, 1e-9);
  EXPECT_NEAR(plain->panels[0].placement.translation.y, 0.02, 1e-12);
  EXPECT_NEAR(plain->panels[0].placement.rotation.z, 90, 1e-9);
  const auto thirds =
      garmentcode::read_garmentcode(square(kPlainEdges, "", R"(, "properties": {"units_in_meter": 300})"));
  ASSERT_TRUE(thirds.ok()) << to_string(thirds.error());
  EXPECT_NEAR(pattern::arc_length(thirds->pattern.panels[0].outline.edges[0]), 100.0 / 3, 1e-9);
  EXPECT_NEAR(thirds->panels[0].placement.translation.y, 0.02 / 3, 1e-12);
}

/// A bodice half whose neckline is an arc of `radius` about its neck point at (5, 46), sewn nowhere.
std::string bodice(double radius) {
  return R"({"pattern": {"panels": {"front": {"vertices": [[0, 0], [25, 0], [25, 20], [17, 41], [5, 46], [0, 15]],
    "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 4]},
      {"endpoints": [4, 5], "curvature": {"type": "circle", "params": [)" +
         std::to_string(radius) + R"(, 0, 0]}}, {"endpoints": [5, 0]}]}}}})";
}

TEST(GarmentCodeRead, ANecklineThatRunsPastTheShoulderEndsOnIt) {
  const auto read = garmentcode::read_garmentcode(bodice(15.9));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const pattern::Panel& panel = read->pattern.panels[0];
  EXPECT_TRUE(pattern::validate(panel).ok());
  ASSERT_EQ(panel.outline.edges.size(), 6u);
  const Vec2 end = panel.outline.edges[3].curves.back().p3;
  EXPECT_EQ(end, panel.outline.edges[4].curves.front().p0);
  const Vec2 along = normalized(Vec2{170, 410} - Vec2{50, 460});
  EXPECT_NEAR(cross(end - Vec2{50, 460}, along), 0, 1e-3) << "on the shoulder line";
  EXPECT_GT(dot(end - Vec2{50, 460}, along), 1);
  ASSERT_EQ(read->notes.size(), 1u);
  EXPECT_NE(read->notes[0].find("/pattern/panels/front"), std::string::npos) << read->notes[0];
}

TEST(GarmentCodeRead, AnOutlineThatCrossesItselfElsewhereIsRefused) {
  const Error crossed = error_of(
      R"({"pattern": {"panels": {"front": {"vertices": [[0, 0], [20, 0], [2, 20], [18, 20]], "edges":
        [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}}}})");
  EXPECT_EQ(crossed.code, "pattern.self_crossing");
}

TEST(GarmentCodeRead, TakesControlPointsRelativeToTheEdge) {
  const auto bare = garmentcode::read_garmentcode(with_first_edge("[0.5, -0.2]"));
  ASSERT_TRUE(bare.ok()) << to_string(bare.error());
  const Vec2 m = middle(bare->pattern.panels[0].outline.edges[0]);
  EXPECT_NEAR(m.x, 50, 1e-6);
  EXPECT_NEAR(m.y, -10, 1e-6) << "half way to the control point";
  const auto named =
      garmentcode::read_garmentcode(with_first_edge(R"({"type": "quadratic", "params": [[0.5, -0.2]]})"));
  ASSERT_TRUE(named.ok()) << to_string(named.error());
  EXPECT_EQ(middle(named->pattern.panels[0].outline.edges[0]), m);
  const auto cubic = garmentcode::read_garmentcode(
      with_first_edge(R"({"type": "cubic", "params": [[0.2, -0.2], [0.8, -0.2]]})"));
  ASSERT_TRUE(cubic.ok()) << to_string(cubic.error());
  EXPECT_NEAR(middle(cubic->pattern.panels[0].outline.edges[0]).y, -15, 1e-6) << "three quarters";
}

TEST(GarmentCodeRead, TakesTheRadiusOfACircleAsALength) {
  const auto read =
      garmentcode::read_garmentcode(with_first_edge(R"({"type": "circle", "params": [5, 0, 1]})"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const pattern::PanelEdge& edge = read->pattern.panels[0].outline.edges[0];
  EXPECT_NEAR(pattern::arc_length(edge), 50 * kPi, 1e-3);
  EXPECT_NEAR(middle(edge).y, -50, 1e-3) << "left of the way from start to end bends outwards here";
}

TEST(GarmentCodeArc, RunsTheLongOrTheShortWayLeftOrRight) {
  for (const bool large : {false, true}) {
    for (const bool left : {false, true}) {
      pattern::PanelEdge edge{"arc", garmentcode::cubics_from_arc({0, 0}, {10, 0}, 7, large, left)};
      const double narrow = 2 * std::asin(5.0 / 7);
      EXPECT_NEAR(pattern::arc_length(edge), 7 * (large ? 2 * kPi - narrow : narrow), 1e-4);
      const double sagitta = large ? 7 + std::sqrt(24.0) : 7 - std::sqrt(24.0);
      EXPECT_NEAR(middle(edge).y, left ? -sagitta : sagitta, 1e-4) << large << left;
      EXPECT_EQ(edge.curves.back().p3, (Vec2{10, 0}));
    }
  }
  const pattern::PanelEdge half{"arc", garmentcode::cubics_from_arc({0, 0}, {10, 0}, 1, false, true)};
  EXPECT_NEAR(pattern::arc_length(half), 5 * kPi, 1e-4) << "a radius too small becomes half the chord";
}

TEST(GarmentCodeRead, TurnsAClockwisePanelToItsRightSideWithoutMovingIt) {
  const std::string back =
      square(R"({"endpoints": [0, 3]}, {"endpoints": [3, 2]}, {"endpoints": [2, 1]}, {"endpoints": [1, 0]})");
  const auto read = garmentcode::read_garmentcode(back);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_GT(pattern::signed_area(read->pattern.panels[0].outline), 0);
  EXPECT_TRUE(read->panels[0].placement.flipped);
  const pattern::PanelEdge& first = read->pattern.panels[0].outline.edges[0];
  const Vec3 degrees = read->panels[0].placement.rotation;
  const sewing::RigidPlacement rigid{
      read->panels[0].placement.translation,
      {radians_from_degrees(degrees.x), radians_from_degrees(degrees.y), radians_from_degrees(degrees.z)},
      true};
  const Vec2 end = first.curves.back().p3 * 1e-3;
  const Vec3 placed = sewing::place({end}, rigid)[0];  // (0, 0.1) turned by 90° about z
  EXPECT_NEAR(placed.x, 0.01 - 0.1, 1e-9);
  EXPECT_NEAR(placed.y, 0.02, 1e-9);
  EXPECT_NEAR(placed.z, 0.03, 1e-9);
}

TEST(GarmentCodeRead, KeepsAllStitchesLabelsAndTheOrderOfPanels) {
  const std::string panel = R"({"label": "leg", "vertices": [[0, 0], [10, 0], [0, 10]], "edges":
    [{"endpoints": [0, 1], "label": "hem"}, {"endpoints": [1, 2]}, {"endpoints": [2, 0]}]})";
  const std::string text = R"({"pattern": {"panels": {"b": )" + panel + R"(, "a": )" + panel +
                           R"(}, "panel_order": ["a", "b"], "stitches": [
    [{"panel": "a", "edge": 1}, {"panel": "b", "edge": 1}], [{"panel": "a", "edge": 1}, {"panel": "b", "edge": 2}],
    [{"panel": "a", "edge": 2}, {"panel": "b", "edge": 2}]]}})";
  const auto read = garmentcode::read_garmentcode(text);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->pattern.panels[0].id, "a");
  EXPECT_EQ(read->panels[0].label, "leg");
  EXPECT_EQ(read->panels[1].edge_labels, (std::vector<std::string>{"hem", "", ""}));
  ASSERT_EQ(read->pattern.seams.size(), 2u);
  EXPECT_EQ(read->pattern.seams[1].id, "seam2");
  ASSERT_EQ(read->notes.size(), 1u) << "the edge that is stitched twice";
  EXPECT_NE(read->notes[0].find("/pattern/stitches/1"), std::string::npos) << read->notes[0];
  EXPECT_TRUE(pattern::validate(read->pattern).ok());
}

TEST(GarmentCodeRead, NamesThePlaceOfWhatIsBroken) {
  struct Case {
    std::string text, code, where;
  };
  const std::string front = "/pattern/panels/front";
  const std::vector<Case> cases{
      {"{\"pattern\": ", "json.syntax", ""},
      {"[]", "garmentcode.type", ""},
      {"{}", "garmentcode.missing", "/pattern"},
      {R"({"pattern": {"panels": {}}})", "garmentcode.no_panels", "/pattern/panels"},
      {R"({"pattern": {"panels": []}})", "garmentcode.type", "/pattern/panels"},
      {R"({"pattern": {"panels": {"front": 3}}})", "garmentcode.type", front},
      {R"({"pattern": {"panels": {"front": {}}}})", "garmentcode.missing", front + "/vertices"},
      {square(R"({"endpoints": [0, 1]}, {"endpoints": [2, 3]})"), "garmentcode.open_outline",
       front + "/edges/1"},
      {square(R"({"endpoints": [0, 1]}, {"endpoints": [1, 2]})"), "garmentcode.open_outline",
       front + "/edges"},
      {square(R"({"endpoints": [0, 9]}, {"endpoints": [9, 0]})"), "garmentcode.reference",
       front + "/edges/0/endpoints/1"},
      {square(R"({"endpoints": [0, 1.5]}, {"endpoints": [1, 0]})"), "garmentcode.reference",
       front + "/edges/0/endpoints/1"},
      {square(R"({"endpoints": [0, 0]}, {"endpoints": [0, 0]})"), "garmentcode.edge_without_length",
       front + "/edges/0"},
      {with_first_edge(R"({"type": "spiral", "params": []})"), "garmentcode.curve",
       front + "/edges/0/curvature/type"},
      {with_first_edge(R"({"type": "cubic", "params": [[0, 1]]})"), "garmentcode.range",
       front + "/edges/0/curvature/params"},
      {with_first_edge(R"({"type": "circle", "params": [-5, 0, 1]})"), "garmentcode.range",
       front + "/edges/0/curvature/params/0"},
      {with_first_edge("[0.5]"), "garmentcode.range", front + "/edges/0/curvature"},
      {with_first_edge("[0.5, 1e300]"), "garmentcode.range", front + "/edges/0/curvature/1"},
      {with_first_edge("[0.5, 2.5]"), "pattern.self_crossing", front + ": piece front, edge e0"},
      {square(kPlainEdges,
              R"(, "stitches": [[{"panel": "front", "edge": 4}, {"panel": "front", "edge": 1}]])"),
       "garmentcode.reference", "/pattern/stitches/0/0/edge"},
      {square(kPlainEdges,
              R"(, "stitches": [[{"panel": "rear", "edge": 1}, {"panel": "front", "edge": 1}]])"),
       "garmentcode.reference", "/pattern/stitches/0/0/panel"},
      {square(kPlainEdges, R"(, "stitches": [[{"panel": "front", "edge": 1}]])"), "garmentcode.range",
       "/pattern/stitches/0"},
      {square(kPlainEdges, "", R"(, "properties": {"units_in_meter": 0})"), "garmentcode.unit",
       "/properties/units_in_meter"},
  };
  for (const Case& c : cases) {
    const Error error = error_of(c.text);
    EXPECT_EQ(error.code, c.code) << to_string(error) << "\n" << c.text;
    if (!c.where.empty()) {
      EXPECT_EQ(error.where, c.where) << error.message;
    }
  }
}

// -- The five garments of the shared data, against the same data drawn as polylines by another program
// --------

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

double at(const json::JsonValue& list, std::size_t i) { return *(*list.array())[i].number(); }

TEST(GarmentCodeRead, GivesTheFiveGarmentsAsTheyAreDrawnElsewhere) {
  const char* shared = std::getenv("TOILE_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "TOILE_SHARED is not set: NO REAL SPECIFICATION WAS READ";
  for (const std::string name : {"skirt_2panel", "pants", "tshirt", "hoody", "fitted_blouse_long"}) {
    const std::string stem = std::string(shared) + "/data/garmentcode/" + name;
    const auto read = garmentcode::read_garmentcode(text_of(stem + "_specification.json"));
    ASSERT_TRUE(read.ok()) << name << ": " << to_string(read.error());
    const auto truth = json::parse_json(text_of(stem + ".seams.json"));
    ASSERT_TRUE(truth.ok());
    EXPECT_EQ(read->pattern.panels.size(), truth->find("panels")->object()->size());
    EXPECT_EQ(read->pattern.seams.size(), truth->find("stitches")->array()->size());
    EXPECT_TRUE(read->notes.empty());
    EXPECT_TRUE(pattern::validate(read->pattern).ok());
    for (std::size_t p = 0; p < read->pattern.panels.size(); ++p) {
      const pattern::Panel& panel = read->pattern.panels[p];
      const double side = read->panels[p].placement.flipped ? -1 : 1;
      const json::JsonValue& edges = *truth->find("panels")->find(panel.id)->find("edges");
      for (std::size_t e = 0; e < panel.outline.edges.size(); ++e) {
        const json::JsonValue& edge = (*edges.array())[e];
        EXPECT_NEAR(pattern::arc_length(panel.outline.edges[e]), *edge.find("len_mm")->number(), 0.2)
            << name << " " << panel.id << " " << e;
        const json::JsonValue& points = *edge.find("pts");
        const json::JsonValue& mid = (*points.array())[points.array()->size() / 2];
        const Vec2 drawn{side * at(mid, 0), at(mid, 1)};
        double nearest = 1e9;
        for (const Vec2 q : pattern::flatten(panel.outline.edges[e], 1e-3))
          nearest = std::min(nearest, length(q - drawn));
        if (points.array()->size() > 2) {
          EXPECT_LT(nearest, 3) << name << " " << panel.id << " " << e;
        }
        EXPECT_NEAR(panel.outline.edges[e].curves.front().p0.x, side * at((*points.array())[0], 0), 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace toile
