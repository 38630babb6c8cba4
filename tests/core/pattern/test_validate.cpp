#include "core/pattern/validate.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "core/pattern/curve.h"
#include "core/pattern/outline.h"

namespace toile {
namespace {

pattern::Panel square(const std::string& id, double size = 100) {
  pattern::Panel panel;
  panel.id = id;
  panel.outline = *pattern::loop_from_polyline({{0, 0}, {size, 0}, {size, size}, {0, size}}, {});
  return panel;
}

pattern::Loop hole_at(Vec2 p, const std::string& prefix) {
  pattern::Loop hole = pattern::reversed(
      *pattern::loop_from_polyline({p, p + Vec2{10, 0}, p + Vec2{10, 10}, p + Vec2{0, 10}}, {}));
  for (pattern::PanelEdge& e : hole.edges) e.id = prefix + e.id;
  return hole;
}

pattern::Pattern two_squares() {
  pattern::Pattern pattern{{square("front"), square("back")}, {}};
  pattern.panels[0].holes.push_back(hole_at({20, 20}, "h0"));
  pattern.seams.push_back({"side_left", {{0, 1, false}}, {{1, 3, false}}, false});
  pattern.seams.push_back({"side_right", {{0, 3, false}}, {{1, 1, false}}, false});
  return pattern;
}

pattern::InnerLine line_through(const std::string& id, std::vector<Vec2> points) {
  return {id, std::move(points)};
}

Error broken(const std::function<void(pattern::Pattern&)>& change) {
  pattern::Pattern pattern = two_squares();
  change(pattern);
  const Status status = pattern::validate(pattern);
  return status ? Error{"accepted", "", ""} : status.error();
}

TEST(Validate, AWholePatternPasses) {
  const Status status = pattern::validate(two_squares());
  EXPECT_TRUE(status) << to_string(status.error());
  EXPECT_TRUE(pattern::validate(pattern::Pattern{}));
}

TEST(Validate, IdsAreThereAndUnique) {
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.panels[1].id = "front"; }).code, "pattern.duplicate_id");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.panels[1].id = ""; }).code, "pattern.missing_id");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.seams[1].id = "side_left"; }).where, "seam side_left");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.panels[0].holes[0].edges[1].id = "e2"; }).where,
            "piece front, edge e2");
}

TEST(Validate, LoopsAreClosedExactly) {
  const Error e = broken([](pattern::Pattern& p) { p.panels[0].outline.edges[3].curves[0].p3.x = 1e-9; });
  EXPECT_EQ(e.code, "pattern.open_outline");
  EXPECT_EQ(e.where, "piece front, edge e0");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.panels[0].outline.edges.clear(); }).code,
            "pattern.empty_edge");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.panels[0].outline.edges[2].curves.clear(); }).where,
            "piece front, edge e2");
}

TEST(Validate, CoordinatesAreFiniteAndEarthly) {
  const auto set = [](double x) {
    return [x](pattern::Pattern& p) { p.panels[1].outline.edges[2].curves[0].p1.x = x; };
  };
  EXPECT_EQ(broken(set(std::numeric_limits<double>::quiet_NaN())).where, "piece back, edge e2");
  EXPECT_EQ(broken(set(std::numeric_limits<double>::infinity())).code, "pattern.not_finite");
  EXPECT_EQ(broken(set(1e300)).code, "pattern.too_large");
}

TEST(Validate, OutlinesRunCounterClockwiseAndHolesClockwise) {
  EXPECT_EQ(
      broken([](pattern::Pattern& p) { p.panels[0].outline = pattern::reversed(p.panels[0].outline); }).code,
      "pattern.clockwise");
  const Error e =
      broken([](pattern::Pattern& p) { p.panels[0].holes[0] = pattern::reversed(p.panels[0].holes[0]); });
  EXPECT_EQ(e.code, "pattern.clockwise");
  EXPECT_EQ(e.where, "piece front, hole 0");
}

TEST(Validate, AnOutlineThatCrossesItselfIsPlaced) {
  const Error e = broken([](pattern::Pattern& p) {
    pattern::CubicBezier& c =
        p.panels[1].outline.edges[1].curves[0];  // from (100, 0) up; bend it over the left side
    c.p1 = {-200, 30};
    c.p2 = {-200, 60};
  });
  EXPECT_EQ(e.code, "pattern.self_crossing");
  EXPECT_EQ(e.where, "piece back, edge e1");
}

TEST(Validate, TellsLinesThatCrossFromOtherFaults) {
  const pattern::Panel whole = two_squares().panels[0];
  EXPECT_FALSE(pattern::has_crossing_lines(whole));
  pattern::Panel crossed = whole;
  crossed.holes[0] = hole_at({95, 20}, "h0");
  EXPECT_TRUE(pattern::has_crossing_lines(crossed));
  pattern::Panel outside = whole;
  outside.holes[0] = hole_at({500, 20}, "h0");
  EXPECT_TRUE(pattern::has_crossing_lines(outside));
  crossed.grain = {2, 0};
  EXPECT_FALSE(pattern::has_crossing_lines(crossed)) << "the grain is told first";
  pattern::Panel flat = whole;
  flat.holes.clear();
  flat.outline.edges = {{"e0", {pattern::line_segment({0, 0}, {9, 0})}},
                        {"e1", {pattern::line_segment({9, 0}, {0, 0})}}};
  EXPECT_FALSE(pattern::has_crossing_lines(flat)) << "that it has no area says more";
}

TEST(Validate, APieceWithoutAreaIsRefused) {
  const Error e = broken([](pattern::Pattern& p) {
    p.panels[0].holes.clear();
    p.panels[0].outline.edges = {{"e0", {pattern::line_segment({0, 0}, {9, 0})}},
                                 {"e1", {pattern::line_segment({9, 0}, {0, 0})}}};
    p.seams.clear();
  });
  EXPECT_EQ(e.code, "pattern.zero_area");
  EXPECT_EQ(e.where, "piece front");
}

TEST(Validate, HolesLieInTheClothApart) {
  EXPECT_EQ(broken([](pattern::Pattern& p) {
              p.panels[0].holes[0] = hole_at({500, 20}, "h0");
            }).code,
            "pattern.hole_outside");
  EXPECT_EQ(broken([](pattern::Pattern& p) {
              p.panels[0].holes[0] = hole_at({95, 20}, "h0");
            }).code,
            "pattern.self_crossing");
  EXPECT_EQ(broken([](pattern::Pattern& p) {
              p.panels[0].holes.push_back(hole_at({25, 25}, "h1"));
            }).code,
            "pattern.self_crossing");
}

TEST(Validate, TheGrainIsADirection) {
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.panels[1].grain = {0, 2}; }).code, "pattern.bad_grain");
  EXPECT_EQ(broken([](pattern::Pattern& p) {
              p.panels[1].grain = {0, std::numeric_limits<double>::quiet_NaN()};
            }).where,
            "piece back");
}

TEST(Validate, SeamsReferToEdgesThatExist) {
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.seams[0].a[0].panel = 7; }).where,
            "seam side_left, side a, item 0");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.seams[0].a[0].panel = -1; }).code, "pattern.seam_reference");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.seams[1].b[0].edge = 4; }).where,
            "seam side_right, side b, item 0");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.seams[0].a[0].edge = 7; }).code, "accepted")
      << "the hole's last edge";
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.seams[0].a[0].edge = 8; }).code, "pattern.seam_reference");
  EXPECT_EQ(broken([](pattern::Pattern& p) { p.seams[0].b.clear(); }).code, "pattern.empty_seam_side");
}

TEST(Validate, AnEdgeIsSewnOnce) {
  const Error series = broken([](pattern::Pattern& p) { p.seams[0].a.push_back({0, 1, true}); });
  EXPECT_EQ(series.code, "pattern.edge_sewn_twice");
  EXPECT_EQ(series.where, "seam side_left, side a, item 1");
  const Error seams = broken([](pattern::Pattern& p) { p.seams[1].a[0] = {0, 1, false}; });
  EXPECT_EQ(seams.code, "pattern.edge_sewn_twice");
  EXPECT_NE(seams.message.find("seam side_left, side a, item 0"), std::string::npos);
}

TEST(Validate, ALineMayRunAnywhereInTheClothAndEndOnTheOutline) {
  pattern::Pattern pattern = two_squares();
  pattern.panels[0].lines = {line_through("fold", {{0, 50}, {50, 60}, {100, 50}})};
  EXPECT_TRUE(pattern::validate(pattern));
}

TEST(Validate, ALineThatIsOnlyDrawnMayLeaveTheClothButHasAnIdAndPlaces) {
  const auto drawn = [](pattern::InnerLine line) {
    line.drawn = true;
    pattern::Pattern pattern = two_squares();
    pattern.panels[0].lines = {std::move(line)};
    return pattern::validate(pattern);
  };
  EXPECT_TRUE(drawn(line_through("mark", {{50, 50}, {50, 50}, {150, 50}})));
  EXPECT_EQ(drawn(line_through("", {{50, 50}, {60, 50}})).error().code, "pattern.missing_id");
  EXPECT_EQ(drawn(line_through("e0", {{50, 50}, {60, 50}})).error().code, "pattern.duplicate_id");
  EXPECT_EQ(drawn(line_through("mark", {{NAN, 50}, {60, 50}})).error().code, "pattern.not_finite");
  EXPECT_EQ(drawn(line_through("mark", {{50, 50}})).error().code, "pattern.bad_line");
}

TEST(Validate, ALineThatIsNoneIsRefusedWithItsName) {
  const auto with = [](std::vector<pattern::InnerLine> lines) {
    return broken([&](pattern::Pattern& p) { p.panels[0].lines = std::move(lines); });
  };
  EXPECT_EQ(with({line_through("fold", {{50, 50}})}).code, "pattern.bad_line");
  EXPECT_EQ(with({line_through("fold", {{50, 50}, {50, 50}})}).code, "pattern.bad_line");
  EXPECT_EQ(with({line_through("fold", {{50, 50}, {150, 50}})}).code, "pattern.bad_line");
  EXPECT_EQ(with({line_through("fold", {{50, 50}, {25, 25}})}).code, "pattern.bad_line") << "in a hole";
  EXPECT_EQ(with({line_through("", {{50, 50}, {60, 50}})}).code, "pattern.missing_id");
  EXPECT_EQ(with({line_through("e0", {{50, 50}, {60, 50}})}).code, "pattern.duplicate_id") << "an edge's";
  EXPECT_EQ(with({line_through("fold", {{50, 50}, {NAN, 50}})}).code, "pattern.not_finite");
  EXPECT_NE(with({line_through("fold", {{50, 50}})}).where.find("line fold"), std::string::npos);
}

}  // namespace
}  // namespace toile
