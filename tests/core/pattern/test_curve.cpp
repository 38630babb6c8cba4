#include "core/pattern/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"

namespace toile {
namespace {

const pattern::CubicBezier kCurve{{0, 0}, {30, 80}, {90, -40}, {120, 20}};

double chord_length(const pattern::CubicBezier& c, double t0, double t1, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i)
    sum += length(pattern::evaluate(c, t0 + (t1 - t0) * (i + 1) / n) -
                  pattern::evaluate(c, t0 + (t1 - t0) * i / n));
  return sum;
}

TEST(Curve, EndsAreExactAndDerivativesMatchDifferences) {
  EXPECT_EQ(pattern::evaluate(kCurve, 0), kCurve.p0);
  EXPECT_EQ(pattern::evaluate(kCurve, 1), kCurve.p3);
  const double h = 1e-6;
  for (double t : {0.1, 0.5, 0.83}) {
    const Vec2 d = (pattern::evaluate(kCurve, t + h) - pattern::evaluate(kCurve, t - h)) * (1 / (2 * h));
    EXPECT_NEAR(length(d - pattern::derivative(kCurve, t)), 0, 1e-5);
    const Vec2 dd = (pattern::derivative(kCurve, t + h) - pattern::derivative(kCurve, t - h)) * (1 / (2 * h));
    EXPECT_NEAR(length(dd - pattern::second_derivative(kCurve, t)), 0, 1e-4);
  }
}

TEST(Curve, LengthMatchesFineChordsAndIsExactForLinesAndCusps) {
  EXPECT_NEAR(pattern::arc_length(kCurve), chord_length(kCurve, 0, 1, 200'000), 1e-6);
  EXPECT_NEAR(pattern::arc_length(kCurve, 0.2, 0.7), chord_length(kCurve, 0.2, 0.7, 200'000), 1e-6);
  EXPECT_NEAR(pattern::arc_length(pattern::line_segment({1, 2}, {4, 6})), 5, 1e-12);
  const pattern::CubicBezier cusp{{0, 0}, {100, 100}, {0, 100}, {100, 0}};
  EXPECT_NEAR(pattern::arc_length(cusp), chord_length(cusp, 0, 1, 400'000), 1e-4);
  EXPECT_EQ(pattern::arc_length(pattern::line_segment({1, 1}, {1, 1})), 0);
}

TEST(Curve, ParameterAtLengthInvertsLength) {
  const double whole = pattern::arc_length(kCurve);
  for (double f : {0.0, 0.01, 0.25, 0.5, 0.9, 1.0}) {
    const double t = pattern::parameter_at_length(kCurve, f * whole);
    EXPECT_NEAR(pattern::arc_length(kCurve, 0, t), f * whole, 1e-7 * whole);
  }
  EXPECT_EQ(pattern::parameter_at_length(kCurve, -5), 0);
  EXPECT_EQ(pattern::parameter_at_length(kCurve, 1e9), 1);
}

TEST(Curve, PointAtLengthWalksAcrossTheCurvesOfAnEdge) {
  const pattern::PanelEdge edge{
      "e0", {pattern::line_segment({0, 0}, {10, 0}), pattern::line_segment({10, 0}, {10, 30})}};
  EXPECT_NEAR(length(pattern::point_at_length(edge, 25) - Vec2{10, 15}), 0, 1e-9);
  EXPECT_EQ(pattern::point_at_length(edge, 99), (Vec2{10, 30}));
  EXPECT_DOUBLE_EQ(pattern::arc_length(edge), 40);
}

TEST(Curve, SplitPartsFollowTheWholeAndKeepItsEnds) {
  const auto [a, b] = pattern::split(kCurve, 0.3);
  EXPECT_EQ(a.p0, kCurve.p0);
  EXPECT_EQ(a.p3, b.p0);
  EXPECT_EQ(b.p3, kCurve.p3);
  for (double t : {0.0, 0.4, 1.0}) {
    EXPECT_NEAR(length(pattern::evaluate(a, t) - pattern::evaluate(kCurve, 0.3 * t)), 0, 1e-12);
    EXPECT_NEAR(length(pattern::evaluate(b, t) - pattern::evaluate(kCurve, 0.3 + 0.7 * t)), 0, 1e-12);
  }
}

TEST(Curve, FlatteningStaysWithinItsTolerance) {
  for (double tolerance : {1.0, 0.1, 0.01}) {
    const std::vector<Vec2> flat = pattern::flatten(kCurve, tolerance);
    for (int i = 0; i <= 1000; ++i) {
      double nearest = 1e9;
      for (std::size_t k = 1; k < flat.size(); ++k)
        nearest = std::min(nearest, geometry::distance_to_segment(pattern::evaluate(kCurve, i / 1000.0),
                                                                  flat[k - 1], flat[k]));
      EXPECT_LE(nearest, tolerance);
    }
  }
  EXPECT_LT(pattern::flatten(kCurve, 1.0).size(), pattern::flatten(kCurve, 0.01).size());
  EXPECT_EQ(pattern::flatten(pattern::line_segment({0, 0}, {1000, 1}), 1e-9).size(), 2u);
}

TEST(Curve, FlattenedLoopListsEveryPointOnce) {
  const pattern::Loop loop{
      {{"a", {pattern::line_segment({0, 0}, {10, 0})}},
       {"b", {pattern::line_segment({10, 0}, {10, 10}), pattern::line_segment({10, 10}, {0, 0})}}}};
  EXPECT_EQ(pattern::flatten(loop, 0.1), (std::vector<Vec2>{{0, 0}, {10, 0}, {10, 10}}));
}

TEST(Curve, AreaOfALoopIsExact) {
  const pattern::Loop triangle{
      {{"a",
        {pattern::line_segment({0, 0}, {10, 0}), pattern::line_segment({10, 0}, {0, 8}),
         pattern::line_segment({0, 8}, {0, 0})}}}};
  EXPECT_NEAR(pattern::signed_area(triangle), 40, 1e-12);
  EXPECT_NEAR(pattern::signed_area(pattern::reversed(triangle)), -40, 1e-12);
  const pattern::Loop bow{{{"a", {kCurve, pattern::line_segment(kCurve.p3, kCurve.p0)}}}};
  EXPECT_NEAR(pattern::signed_area(bow), geometry::signed_area(pattern::flatten(bow, 1e-4)), 1e-2);
}

TEST(Curve, ReversedLoopKeepsItsFirstEdgeFirst) {
  const pattern::Loop loop{{{"a", {pattern::line_segment({0, 0}, {10, 0})}},
                            {"b", {pattern::line_segment({10, 0}, {0, 8})}},
                            {"c", {pattern::line_segment({0, 8}, {0, 0})}}}};
  const pattern::Loop back = pattern::reversed(loop);
  EXPECT_EQ(back.edges[0].id, "a");
  EXPECT_EQ(back.edges[1].id, "c");
  EXPECT_EQ(back.edges[0].curves[0].p3, back.edges[1].curves[0].p0);
  EXPECT_EQ(back.edges[2].curves[0].p3, back.edges[0].curves[0].p0);
}

TEST(Curve, StraightMeansAlongTheChord) {
  EXPECT_TRUE(pattern::is_straight(pattern::line_segment({0, 0}, {5, 5})));
  EXPECT_FALSE(pattern::is_straight(kCurve));
  EXPECT_FALSE(pattern::is_straight({{0, 0}, {20, 0}, {-10, 0}, {10, 0}})) << "turns back on its own line";
}

}  // namespace
}  // namespace toile
