#include "core/pattern/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/geometry/polygon2.h"

namespace toile {
namespace {

const CubicBezier kCurve{{0, 0}, {30, 80}, {90, -40}, {120, 20}};

double chord_length(const CubicBezier& c, double t0, double t1, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i)
    sum += length(evaluate(c, t0 + (t1 - t0) * (i + 1) / n) - evaluate(c, t0 + (t1 - t0) * i / n));
  return sum;
}

TEST(Curve, EndsAreExactAndDerivativesMatchDifferences) {
  EXPECT_EQ(evaluate(kCurve, 0), kCurve.p0);
  EXPECT_EQ(evaluate(kCurve, 1), kCurve.p3);
  const double h = 1e-6;
  for (double t : {0.1, 0.5, 0.83}) {
    const Vec2 d = (evaluate(kCurve, t + h) - evaluate(kCurve, t - h)) * (1 / (2 * h));
    EXPECT_NEAR(length(d - derivative(kCurve, t)), 0, 1e-5);
    const Vec2 dd = (derivative(kCurve, t + h) - derivative(kCurve, t - h)) * (1 / (2 * h));
    EXPECT_NEAR(length(dd - second_derivative(kCurve, t)), 0, 1e-4);
  }
}

TEST(Curve, LengthMatchesFineChordsAndIsExactForLinesAndCusps) {
  EXPECT_NEAR(arc_length(kCurve), chord_length(kCurve, 0, 1, 200'000), 1e-6);
  EXPECT_NEAR(arc_length(kCurve, 0.2, 0.7), chord_length(kCurve, 0.2, 0.7, 200'000), 1e-6);
  EXPECT_NEAR(arc_length(line_segment({1, 2}, {4, 6})), 5, 1e-12);
  const CubicBezier cusp{{0, 0}, {100, 100}, {0, 100}, {100, 0}};
  EXPECT_NEAR(arc_length(cusp), chord_length(cusp, 0, 1, 400'000), 1e-4);
  EXPECT_EQ(arc_length(line_segment({1, 1}, {1, 1})), 0);
}

TEST(Curve, ParameterAtLengthInvertsLength) {
  const double whole = arc_length(kCurve);
  for (double f : {0.0, 0.01, 0.25, 0.5, 0.9, 1.0}) {
    const double t = parameter_at_length(kCurve, f * whole);
    EXPECT_NEAR(arc_length(kCurve, 0, t), f * whole, 1e-7 * whole);
  }
  EXPECT_EQ(parameter_at_length(kCurve, -5), 0);
  EXPECT_EQ(parameter_at_length(kCurve, 1e9), 1);
}

TEST(Curve, PointAtLengthWalksAcrossTheCurvesOfAnEdge) {
  const PanelEdge edge{"e0", {line_segment({0, 0}, {10, 0}), line_segment({10, 0}, {10, 30})}};
  EXPECT_NEAR(length(point_at_length(edge, 25) - Vec2{10, 15}), 0, 1e-9);
  EXPECT_EQ(point_at_length(edge, 99), (Vec2{10, 30}));
  EXPECT_DOUBLE_EQ(arc_length(edge), 40);
}

TEST(Curve, SplitPartsFollowTheWholeAndKeepItsEnds) {
  const auto [a, b] = split(kCurve, 0.3);
  EXPECT_EQ(a.p0, kCurve.p0);
  EXPECT_EQ(a.p3, b.p0);
  EXPECT_EQ(b.p3, kCurve.p3);
  for (double t : {0.0, 0.4, 1.0}) {
    EXPECT_NEAR(length(evaluate(a, t) - evaluate(kCurve, 0.3 * t)), 0, 1e-12);
    EXPECT_NEAR(length(evaluate(b, t) - evaluate(kCurve, 0.3 + 0.7 * t)), 0, 1e-12);
  }
}

TEST(Curve, FlatteningStaysWithinItsTolerance) {
  for (double tolerance : {1.0, 0.1, 0.01}) {
    const std::vector<Vec2> flat = flatten(kCurve, tolerance);
    for (int i = 0; i <= 1000; ++i) {
      double nearest = 1e9;
      for (std::size_t k = 1; k < flat.size(); ++k)
        nearest = std::min(nearest, distance_to_segment(evaluate(kCurve, i / 1000.0), flat[k - 1], flat[k]));
      EXPECT_LE(nearest, tolerance);
    }
  }
  EXPECT_LT(flatten(kCurve, 1.0).size(), flatten(kCurve, 0.01).size());
  EXPECT_EQ(flatten(line_segment({0, 0}, {1000, 1}), 1e-9).size(), 2u);
}

TEST(Curve, FlattenedLoopListsEveryPointOnce) {
  const Loop loop{{{"a", {line_segment({0, 0}, {10, 0})}},
                   {"b", {line_segment({10, 0}, {10, 10}), line_segment({10, 10}, {0, 0})}}}};
  EXPECT_EQ(flatten(loop, 0.1), (std::vector<Vec2>{{0, 0}, {10, 0}, {10, 10}}));
}

TEST(Curve, AreaOfALoopIsExact) {
  const Loop triangle{
      {{"a", {line_segment({0, 0}, {10, 0}), line_segment({10, 0}, {0, 8}), line_segment({0, 8}, {0, 0})}}}};
  EXPECT_NEAR(signed_area(triangle), 40, 1e-12);
  EXPECT_NEAR(signed_area(reversed(triangle)), -40, 1e-12);
  const Loop bow{{{"a", {kCurve, line_segment(kCurve.p3, kCurve.p0)}}}};
  EXPECT_NEAR(signed_area(bow), signed_area(flatten(bow, 1e-4)), 1e-2);
}

TEST(Curve, ReversedLoopKeepsItsFirstEdgeFirst) {
  const Loop loop{{{"a", {line_segment({0, 0}, {10, 0})}},
                   {"b", {line_segment({10, 0}, {0, 8})}},
                   {"c", {line_segment({0, 8}, {0, 0})}}}};
  const Loop back = reversed(loop);
  EXPECT_EQ(back.edges[0].id, "a");
  EXPECT_EQ(back.edges[1].id, "c");
  EXPECT_EQ(back.edges[0].curves[0].p3, back.edges[1].curves[0].p0);
  EXPECT_EQ(back.edges[2].curves[0].p3, back.edges[0].curves[0].p0);
}

TEST(Curve, StraightMeansAlongTheChord) {
  EXPECT_TRUE(is_straight(line_segment({0, 0}, {5, 5})));
  EXPECT_FALSE(is_straight(kCurve));
  EXPECT_FALSE(is_straight({{0, 0}, {20, 0}, {-10, 0}, {10, 0}})) << "turns back on its own line";
}

}  // namespace
}  // namespace toile
