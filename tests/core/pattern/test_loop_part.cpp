// Parts of outlines and of their edges.

#include <gtest/gtest.h>

#include "core/pattern/curve.h"
#include "core/pattern/loop_part.h"
#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

double length_of(const std::vector<pattern::CubicBezier>& curves) {
  return pattern::arc_length(pattern::PanelEdge{"", curves});
}

TEST(LoopPart, EdgesBetweenTwoPlacesAreBrokenThere) {
  const pattern::Panel square = garments::piece("p", {{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  const auto part = pattern::edges_between(square.outline, {40, 0}, {100, 30});
  ASSERT_EQ(part.size(), 2u);
  EXPECT_NEAR(length_of(part[0].curves), 60, 0.1);
  EXPECT_NEAR(length_of(part[1].curves), 30, 0.1);
  const auto rest = pattern::edges_between(square.outline, {100, 30}, {40, 0});
  ASSERT_EQ(rest.size(), 4u) << "around, and back to the edge that it left";
  EXPECT_NEAR(length_of(rest.back().curves), 40, 0.1);
}

TEST(LoopPart, CurvesOfAnEdgeMeetExactlyWhereItIsParted) {
  const pattern::Panel bent = garments::piece("p", {{0, 0, Vec2{60, 90}}, {100, 0}, {50, -80}});
  pattern::PanelEdge edge = bent.outline.edges[0];
  const auto [first, second] = pattern::split(edge.curves[0], 1.0 / 3);
  edge.curves = {first, second};
  const double all = pattern::arc_length(edge);
  for (const double at : {0.1, 0.25, 0.6, 0.9}) {
    const auto before = pattern::curves_between(edge, 0, at), after = pattern::curves_between(edge, at, 1);
    EXPECT_NEAR(length_of(before), at * all, 1e-5);
    EXPECT_NEAR(length_of(after), (1 - at) * all, 1e-5);
    EXPECT_EQ(before.back().p3, after.front().p0) << at;
    EXPECT_EQ(before.front().p0, edge.curves.front().p0);
    EXPECT_EQ(after.back().p3, edge.curves.back().p3);
  }
  EXPECT_EQ(pattern::curves_between(edge, 0, 1).size(), 2u);
  EXPECT_EQ(pattern::curves_between(edge, 0, 1).back().p3, edge.curves.back().p3);
}

}  // namespace
}  // namespace toile
