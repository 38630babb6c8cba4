#include "core/pattern/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/polygon2.h"
#include "core/pattern/corners.h"
#include "core/pattern/curve.h"

namespace toile {
namespace {

const std::vector<Vec2> kRectangle{{0, 0}, {300, 0}, {300, 200}, {0, 200}};

std::vector<Vec2> circle(double radius, double segment) {
  const int n = int(2 * kPi * radius / segment);
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i)
    points.push_back({radius * std::cos(2 * kPi * i / n), radius * std::sin(2 * kPi * i / n)});
  return points;
}

Vec2 at_degrees(double radius, double degrees) {
  const double a = radians_from_degrees(degrees);
  return {radius * std::cos(a), radius * std::sin(a)};
}

/// A 200 × 100 rectangle with all its sides sampled every `step`, and its corners rounded by radius r.
std::vector<Vec2> rounded(double r, double step) {
  std::vector<Vec2> points;
  const Vec2 centres[4] = {{200 - r, r}, {200 - r, 100 - r}, {r, 100 - r}, {r, r}};
  for (int c = 0; c < 4; ++c) {
    const int n = std::max(1, int(r * kPi / 2 / step));
    for (int i = 0; i <= n; ++i) {
      const double a = -kPi / 2 + kPi / 2 * (c + double(i) / n);
      points.push_back(centres[c] + r * Vec2{std::cos(a), std::sin(a)});
    }
    const Vec2 a = points.back(),
               b = centres[(c + 1) % 4] + r * Vec2{std::cos(kPi / 2 * c), std::sin(kPi / 2 * c)};
    for (double s = step; s < length(b - a) - step / 2; s += step)
      points.push_back(a + normalized(b - a) * s);
  }
  return points;
}

void expect_closed(const pattern::Loop& loop) {
  Vec2 end = loop.edges.back().curves.back().p3;
  for (const pattern::PanelEdge& edge : loop.edges)
    for (const pattern::CubicBezier& c : edge.curves) {
      EXPECT_EQ(c.p0, end);
      end = c.p3;
    }
}

TEST(Outline, ARectangleHasFourStraightEdgesFromItsFirstCorner) {
  const auto loop = pattern::loop_from_polyline(kRectangle, {});
  ASSERT_TRUE(loop) << to_string(loop.error());
  ASSERT_EQ(loop->edges.size(), 4u);
  EXPECT_EQ(loop->edges[0].id, "e0");
  EXPECT_EQ(loop->edges[3].id, "e3");
  EXPECT_EQ(loop->edges[0].curves[0].p0, (Vec2{0, 0}));
  EXPECT_EQ(loop->edges[0].curves[0].p3, (Vec2{300, 0}));
  for (const pattern::PanelEdge& e : loop->edges) EXPECT_EQ(e.curves.size(), 1u);
  expect_closed(*loop);
}

TEST(Outline, AClockwiseFileGivesACounterClockwiseLoopFromTheSameFirstCorner) {
  const auto loop = pattern::loop_from_polyline({{0, 0}, {0, 200}, {300, 200}, {300, 0}}, {});
  ASSERT_TRUE(loop);
  EXPECT_NEAR(pattern::signed_area(*loop), 60'000, 1e-6);
  EXPECT_EQ(loop->edges[0].curves[0].p0, (Vec2{0, 0}));
  EXPECT_EQ(loop->edges[0].curves[0].p3, (Vec2{300, 0}));
}

TEST(Outline, EdgesStartAtTheFirstCornerInFileOrderEvenWhenTheFileStartsWithinAnEdge) {
  const auto loop = pattern::loop_from_polyline({{150, 0}, {300, 0}, {300, 200}, {0, 200}, {0, 0}}, {});
  ASSERT_TRUE(loop);
  ASSERT_EQ(loop->edges.size(), 4u);
  EXPECT_EQ(loop->edges[0].curves[0].p0, (Vec2{300, 0}));
  EXPECT_EQ(loop->edges[3].curves.size(), 1u) << "the point amid the straight edge is gone";
}

TEST(Outline, RepeatedVerticesAndMicroEdgesAreCleaned) {
  const auto loop = pattern::loop_from_polyline(
      {{0, 0}, {0, 0}, {0.004, 0}, {300, 0}, {300, 0.003}, {300, 200}, {0, 200}, {0, 0.005}, {0, 0}}, {});
  ASSERT_TRUE(loop) << to_string(loop.error());
  EXPECT_EQ(loop->edges.size(), 4u);
}

TEST(Outline, ACurveSampledEveryFiveMillimetresHasNoCorners) {
  for (double radius : {12.0, 30.0, 80.0, 500.0})
    for (double segment : {0.2, 1.0, 5.0}) {
      const auto loop = pattern::loop_from_polyline(circle(radius, segment), {});
      ASSERT_TRUE(loop);
      EXPECT_EQ(loop->edges.size(), 1u) << radius << " " << segment;
      EXPECT_GE(loop->edges[0].curves.size(), 4u);
      EXPECT_NEAR(pattern::signed_area(*loop), kPi * radius * radius, 0.02 * kPi * radius * radius);
      expect_closed(*loop);
    }
}

TEST(Outline, CornersAreFoundHoweverFinelyTheSidesAreSampled) {
  for (double step : {0.05, 0.5, 5.0}) {
    EXPECT_EQ(pattern::find_corners(rounded(1e-6, step), radians_from_degrees(35)).size(), 4u) << step;
    EXPECT_EQ(pattern::find_corners(rounded(0.5, std::min(step, 0.2)), radians_from_degrees(35)).size(), 4u)
        << "a corner eased by half a millimetre is a corner";
  }
  EXPECT_TRUE(pattern::find_corners(rounded(20, 2), radians_from_degrees(35)).empty())
      << "a round pocket has none";
}

/// 20° at (100, 0), between straight lines.
const std::vector<Vec2> kBent{{0, 0}, {100, 0}, {200, 36}, {200, 200}, {0, 200}};

/// No corner but sharp ones.
pattern::OutlineSettings sharp_only() {
  pattern::OutlineSettings settings;
  settings.blunt_corner_angle = kPi;
  return settings;
}

TEST(Outline, TheCornerAngleIsASetting) {
  pattern::OutlineSettings settings = sharp_only();
  EXPECT_EQ(pattern::loop_from_polyline(kBent, {}, settings)->edges.size(), 4u);
  settings.corner_angle = radians_from_degrees(15);
  EXPECT_EQ(pattern::loop_from_polyline(kBent, {}, settings)->edges.size(), 5u);
}

TEST(Outline, ABluntCornerIsOneWhereTheDrawingTellsIt) {
  pattern::OutlineSettings settings = sharp_only();
  settings.turn_points = {{100, 0}};
  EXPECT_EQ(pattern::loop_from_polyline(kBent, {}, settings)->edges.size(), 5u);
  settings.turn_points = {{150, 18}};
  EXPECT_EQ(pattern::loop_from_polyline(kBent, {}, settings)->edges.size(), 4u)
      << "programs set turn points where lines go on straight, too";
}

TEST(Outline, ABluntCornerIsOneWhereStraightLinesMeet) {
  EXPECT_EQ(pattern::loop_from_polyline(kBent, {})->edges.size(), 5u);
  const std::vector<Vec2> flared{{0, 0}, {400, 0}, {300, 50}, {100, 50}};  // a cuff: 27° at both upper ends
  EXPECT_EQ(pattern::loop_from_polyline(flared, {})->edges.size(), 4u);
}

TEST(Outline, ACurveInFewSamplesHasNoCornerOfItsOwn) {
  // A sleeve's cap, hollow at both ends, in six chords a side, some 50 mm long.
  const std::vector<Vec2> sleeve{{-195, -73}, {215, -73}, {235, 0},   {191, 13},  {156, 46},
                                 {125, 88},   {91, 131},  {51, 164},  {0, 177},   {-51, 166},
                                 {-90, 134},  {-121, 91}, {-150, 47}, {-180, 14}, {-215, 0}};
  EXPECT_EQ(pattern::loop_from_polyline(sleeve, {})->edges.size(), 4u);
}

TEST(Outline, ABluntCornerIsOneWhereALineMeetsACurve) {
  std::vector<Vec2> sleeve{{0, 0}, {200, -60}};  // the underarm, at -17°; the cap begins at 30°
  for (int i = 1; i <= 10; ++i) sleeve.push_back(sleeve.back() + at_degrees(10, 30 + 6 * i));
  sleeve.push_back({0, sleeve.back().y});
  EXPECT_EQ(pattern::loop_from_polyline(sleeve, {})->edges.size(), 4u);
}

TEST(Outline, ABluntCornerIsOneHoweverFinelyTheCurveIsSampled) {
  // The middle of a front, and a neck that goes on from it by `off` degrees to the left.
  const auto edges = [](double off, double bend) {
    std::vector<Vec2> front{{0, 0}, {0, 245}};
    for (int i = 0; i < 28; ++i) front.push_back(front.back() + at_degrees(2, 90 - off - bend * i));
    front.push_back({250, front.back().y});
    front.push_back({250, 0});
    std::reverse(front.begin(), front.end());
    return pattern::loop_from_polyline(front, {})->edges.size();
  };
  EXPECT_EQ(edges(24, 0.05), 5u);
  EXPECT_EQ(edges(24, -0.05), 5u);
  EXPECT_EQ(edges(0, 0.3), 4u) << "it begins smoothly";
  EXPECT_EQ(edges(1.5, 3), 4u) << "a rounded corner";
}

TEST(Outline, ABluntCornerIsOneWhereTwoCurvesMeet) {
  // A sleeve's back seam, of which samples turn by 1°, and its cap, by 2°; the cap begins `off` degrees on.
  const auto is_corner = [](double off) {
    std::vector<Vec2> sleeve{{0, 0}, {150, 0}};
    for (int i = 0; i < 20; ++i) sleeve.push_back(sleeve.back() + at_degrees(12, 84 + i));
    const Vec2 joint = sleeve.back();
    for (int i = 0; i < 12; ++i) sleeve.push_back(sleeve.back() + at_degrees(12, 104 + off + 2 * i));
    sleeve.push_back({0, sleeve.back().y});
    const std::vector<Vec2> corners = pattern::blunt_corners(sleeve, {});
    return std::any_of(corners.begin(), corners.end(), [&](Vec2 p) { return length(p - joint) < 1e-9; });
  };
  EXPECT_TRUE(is_corner(25));
  EXPECT_FALSE(is_corner(10)) << "curves may turn by that between samples";
  EXPECT_FALSE(is_corner(0));
}

/// A sleeve's underarm, 300 mm at 60°, and a curve that begins `off` degrees from it and turns by 6° at each
/// of its samples.
std::vector<Vec2> underarm(double off) {
  std::vector<Vec2> sleeve{{0, 0}, at_degrees(300, 60)};
  for (int i = 0; i < 8; ++i) sleeve.push_back(sleeve.back() + at_degrees(16, 60 + off - 3 - 6 * i));
  sleeve.push_back({sleeve.back().x, 0});
  return sleeve;
}

TEST(Outline, WhatACurveTurnsAtItsEndIsNotOfTheCornerWhereALineMeetsIt) {
  EXPECT_EQ(pattern::loop_from_polyline(underarm(-5.5), {})->edges.size(), 4u)
      << "it bends by 8.5°, 5.5° of it a corner";
  EXPECT_EQ(pattern::loop_from_polyline(underarm(0), {})->edges.size(), 3u)
      << "the line goes on into the curve";
  EXPECT_EQ(pattern::loop_from_polyline(underarm(-5.5), {}, sharp_only())->edges.size(), 3u);
}

TEST(Outline, SamplesOfACurveAreNoCorners) {
  for (const double chord : {10.0, 40.0, 120.0}) {
    std::vector<Vec2> sector;  // half a circle skirt, waist and hem, turning by 12° at each sample
    const double hem = chord / (2 * std::sin(radians_from_degrees(6)));
    for (int i = 0; i <= 15; ++i) sector.push_back(at_degrees(hem, 180 + 12 * i));
    for (int i = 15; i >= 0; --i) sector.push_back(at_degrees(hem / 3, 180 + 12 * i));
    EXPECT_EQ(pattern::loop_from_polyline(sector, {})->edges.size(), 4u) << chord;
  }
}

TEST(Outline, ForcedCornersAreExactlyTheEndsOfEdges) {
  const std::vector<Vec2> points{{0, 0}, {150, 0}, {300, 0}, {300, 200}, {0, 200}};
  const std::vector<Vec2> forced{{150.2, 0.1}, {0, 200}};
  const auto loop = pattern::loop_from_polyline(points, forced);
  ASSERT_TRUE(loop);
  ASSERT_EQ(loop->edges.size(), 2u);
  EXPECT_EQ(loop->edges[0].curves.front().p0, (Vec2{150, 0})) << "e0 starts at the first forced corner";
  EXPECT_EQ(loop->edges[0].curves.back().p3, (Vec2{0, 200}));
  EXPECT_EQ(loop->edges[0].curves.size(), 3u)
      << "right angles that are not named stay sharp within their edge";
  expect_closed(*loop);
}

TEST(Outline, OneForcedCornerMakesOneEdgeRound) {
  const auto loop = pattern::loop_from_polyline(circle(50, 5), std::vector<Vec2>{{50, 0}});
  ASSERT_TRUE(loop);
  ASSERT_EQ(loop->edges.size(), 1u);
  EXPECT_EQ(loop->edges[0].curves.front().p0, loop->edges[0].curves.back().p3);
  EXPECT_NEAR(pattern::signed_area(*loop), kPi * 2500, 30);
}

TEST(Outline, AForcedCornerOffTheOutlineIsNamed) {
  const auto loop = pattern::loop_from_polyline(kRectangle, std::vector<Vec2>{{0, 0}, {150, 0}});
  ASSERT_FALSE(loop);
  EXPECT_EQ(loop.error().code, "pattern.corner_off_outline");
  EXPECT_NE(loop.error().message.find("(150, 0)"), std::string::npos);
  EXPECT_EQ(loop.error().where, "corner 1");
}

TEST(Outline, BadPolylinesAreErrorsWithTheirPlace) {
  EXPECT_EQ(pattern::loop_from_polyline({}, {}).error().code, "pattern.too_few_points");
  EXPECT_EQ(pattern::loop_from_polyline({{0, 0}, {1, 1}, {0, 0}}, {}).error().code, "pattern.too_few_points");
  EXPECT_EQ(pattern::loop_from_polyline({{0, 0}, {5, 5}, {9, 9}}, {}).error().code, "pattern.zero_area");
  const auto eight = pattern::loop_from_polyline({{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {});
  EXPECT_EQ(eight.error().code, "pattern.self_crossing");
  EXPECT_NE(eight.error().where.find("(5, 5)"), std::string::npos);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pattern::loop_from_polyline({{0, 0}, {1, nan}, {1, 1}}, {}).error().where, "point 1");
}

std::vector<pattern::PanelEdge> triangle(Vec2 end = {0, 0}) {
  return {{"hem", {pattern::line_segment({0, 0}, {100, 0})}},
          {"side", {pattern::line_segment({100, 0}, {0, 80})}},
          {"fold", {pattern::line_segment({0, 80}, end)}}};
}

TEST(Outline, ExplicitEdgesMakeALoopAndKeepTheirNames) {
  const auto loop = pattern::loop_from_edges(triangle());
  ASSERT_TRUE(loop);
  EXPECT_EQ(loop->edges[1].id, "side");
  expect_closed(*loop);
}

TEST(Outline, JointsOfAHundredthAreSnappedExactly) {
  auto edges = triangle({0.006, 0.006});
  edges[1].curves[0].p0 = {100, 0.008};
  const auto loop = pattern::loop_from_edges(edges);
  ASSERT_TRUE(loop) << to_string(loop.error());
  expect_closed(*loop);
  EXPECT_EQ(loop->edges[0].curves[0].p0, (Vec2{0, 0}));
}

TEST(Outline, AGapBetweenEdgesNamesTheEdgeAndBothPoints) {
  const auto last = pattern::loop_from_edges(triangle({0, 3}));
  ASSERT_FALSE(last);
  EXPECT_EQ(last.error().code, "pattern.open_outline");
  EXPECT_EQ(last.error().where, "edge hem");
  EXPECT_NE(last.error().message.find("(0, 3)"), std::string::npos);
  EXPECT_NE(last.error().message.find("(0, 0)"), std::string::npos);
  auto edges = triangle();
  edges[1].curves[0].p0 = {102, 0};
  EXPECT_EQ(pattern::loop_from_edges(edges).error().where, "edge side");
}

TEST(Outline, ClockwiseEdgesAreTurnedAndTheFirstStaysFirst) {
  auto edges = triangle();
  std::vector<pattern::PanelEdge> clockwise{pattern::reversed(edges[2]), pattern::reversed(edges[1]),
                                            pattern::reversed(edges[0])};
  const auto loop = pattern::loop_from_edges(clockwise);
  ASSERT_TRUE(loop);
  EXPECT_GT(pattern::signed_area(*loop), 0);
  EXPECT_EQ(loop->edges[0].id, "fold");
  EXPECT_EQ(loop->edges[1].id, "hem");
  expect_closed(*loop);
}

TEST(Outline, BadEdgesAreErrors) {
  EXPECT_EQ(pattern::loop_from_edges({}).error().code, "pattern.empty_edge");
  EXPECT_EQ(pattern::loop_from_edges({{"a", {}}}).error().code, "pattern.empty_edge");
  auto twins = triangle();
  twins[2].id = "hem";
  EXPECT_EQ(pattern::loop_from_edges(twins).error().code, "pattern.duplicate_id");
  EXPECT_EQ(pattern::loop_from_edges(
                {{"a", {pattern::line_segment({0, 0}, {1, 0}), pattern::line_segment({1, 0}, {0, 0})}}})
                .error()
                .code,
            "pattern.zero_area");
}

TEST(Outline, AnEdgeFromPointsKeepsItsEnds) {
  const auto edge = pattern::edge_from_points("neck", {{0, 0}, {0, 0}, {50, 20}, {100, 0}, {100.002, 0}});
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->curves.front().p0, (Vec2{0, 0}));
  EXPECT_EQ(edge->curves.back().p3, (Vec2{100.002, 0}));
  EXPECT_EQ(pattern::edge_from_points("x", {{1, 1}, {1, 1.001}}).error().where, "edge x");
  EXPECT_EQ(pattern::edge_from_points("x", {}).error().code, "pattern.too_few_points");
}

}  // namespace
}  // namespace toile
