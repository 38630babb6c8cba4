#include "core/pattern/fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/curve.h"

namespace toile {
namespace {

double farthest_vertex(const std::vector<Vec2>& points, const std::vector<pattern::CubicBezier>& curves) {
  const std::vector<Vec2> flat = pattern::flatten(pattern::PanelEdge{"e", curves}, 1e-4);
  double worst = 0;
  for (Vec2 p : points) {
    double nearest = 1e9;
    for (std::size_t k = 1; k < flat.size(); ++k)
      nearest = std::min(nearest, geometry::distance_to_segment(p, flat[k - 1], flat[k]));
    worst = std::max(worst, nearest);
  }
  return worst;
}

void expect_joined(const std::vector<pattern::CubicBezier>& curves) {
  for (std::size_t i = 1; i < curves.size(); ++i) EXPECT_EQ(curves[i - 1].p3, curves[i].p0);
}

std::vector<Vec2> samples(const pattern::CubicBezier& c, int n) {
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i) points.push_back(pattern::evaluate(c, double(i) / n));
  return points;
}

TEST(Fit, ASampledCubicComesBackAsOneOrTwo) {
  const pattern::CubicBezier armhole{{0, 0}, {0, 90}, {40, 140}, {120, 160}};
  for (int n : {12, 40, 400}) {
    const std::vector<Vec2> points = samples(armhole, n);
    const auto curves = pattern::fit_polyline(points, 0.1);
    EXPECT_LE(curves.size(), 2u) << n;
    EXPECT_LE(farthest_vertex(points, curves), 0.1 + 1e-3);
    EXPECT_EQ(curves.front().p0, points.front());
    EXPECT_EQ(curves.back().p3, points.back());
    expect_joined(curves);
    EXPECT_NEAR(pattern::arc_length(pattern::PanelEdge{"e", curves}), pattern::arc_length(armhole), 0.3);
  }
}

TEST(Fit, AWavyLineIsWithinToleranceWithFewCurves) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 600; ++i)
    points.push_back({i * 1.0, 20 * std::sin(i / 40.0) + 5 * std::cos(i / 23.0)});
  for (double tolerance : {1.0, 0.1, 0.02}) {
    const auto curves = pattern::fit_polyline(points, tolerance);
    EXPECT_LE(farthest_vertex(points, curves), tolerance + 1e-3);
    EXPECT_LT(curves.size(), 40u);
    expect_joined(curves);
  }
}

TEST(Fit, StraightPointsBecomeOneLineWithHandlesAtTheThirds) {
  const std::vector<Vec2> points{{0, 0}, {10, 5}, {20.001, 10}, {60, 30}};
  const auto curves = pattern::fit_polyline(points, 0.1);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_NEAR(length(curves[0].p1 - Vec2{20, 10}), 0, 1e-12);
}

TEST(Fit, AStraightRunBesideACurveStaysAnExactLine) {
  std::vector<Vec2> points{{0, 0}, {0, 150}};  // then a quarter circle of radius 60 that runs on smoothly
  for (int i = 1; i <= 24; ++i) {
    const double a = kPi / 2 * i / 24;
    points.push_back({60 - 60 * std::cos(a), 150 + 60 * std::sin(a)});
  }
  const auto curves = pattern::fit_polyline(points, 0.1);
  EXPECT_TRUE(pattern::is_straight(curves.front(), 1e-12));
  EXPECT_EQ(curves.front().p3, (Vec2{0, 150}));
  EXPECT_LE(curves.size(), 4u);
  const Vec2 out = pattern::derivative(curves[1], 0);
  EXPECT_NEAR(out.x / out.y, 0, 1e-9) << "the curve leaves along the line";
}

TEST(Fit, ABluntBendBetweenLongLinesIsNotRounded) {
  const std::vector<Vec2> points{{0, 0}, {100, 0}, {200, 5}};  // 2.9°
  const auto curves = pattern::fit_polyline(points, 0.1);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_TRUE(pattern::is_straight(curves[0], 1e-9));
  EXPECT_TRUE(pattern::is_straight(curves[1], 1e-9));
}

TEST(Fit, ASharpBendInTheMiddleStaysSharp) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 20; ++i) points.push_back({i * 5.0, 0.01 * i * i});
  const Vec2 tip = points.back();
  for (int i = 1; i <= 20; ++i) points.push_back({tip.x + 0.01 * i * i, tip.y + i * 5.0});
  const auto curves = pattern::fit_polyline(points, 0.1);
  bool at_tip = false;
  for (const pattern::CubicBezier& c : curves) at_tip = at_tip || c.p3 == tip;
  EXPECT_TRUE(at_tip);
  EXPECT_LE(farthest_vertex(points, curves), 0.1 + 1e-3);
}

TEST(Fit, ACircleIsSmoothEverywhere) {
  std::vector<Vec2> circle;
  for (int i = 0; i < 90; ++i)
    circle.push_back({80 * std::cos(2 * kPi * i / 90), 80 * std::sin(2 * kPi * i / 90)});
  const auto curves = pattern::fit_smooth_loop(circle, 0.1);
  EXPECT_GE(curves.size(), 4u);
  EXPECT_LE(curves.size(), 8u);
  EXPECT_EQ(curves.front().p0, curves.back().p3);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Vec2 in = pattern::derivative(curves[i], 1),
               out = pattern::derivative(curves[(i + 1) % curves.size()], 0);
    EXPECT_NEAR(cross(normalized(in), normalized(out)), 0, 1e-9);
  }
  EXPECT_NEAR(pattern::arc_length(pattern::PanelEdge{"e", curves}), 2 * kPi * 80, 0.2);
}

TEST(Fit, AHundredThousandJaggedPointsAreBoundedWork) {
  std::mt19937 random(3);
  std::vector<Vec2> points;
  for (int i = 0; i < 100'000; ++i) points.push_back({i * 0.5, double(random() % 1000) * 2e-4});
  std::size_t compared = 0;
  const auto curves = pattern::fit_polyline(points, 0.05, {}, &compared);
  EXPECT_GT(curves.size(), 100u);
  EXPECT_LT(compared / points.size(), 40u) << "times that each point was looked at";
  expect_joined(curves);
}

}  // namespace
}  // namespace toile
