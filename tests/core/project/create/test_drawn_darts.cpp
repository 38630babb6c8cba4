#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/validate.h"
#include "core/project/create/create.h"
#include "core/project/create/drawn_darts.h"
#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

using Lines = std::vector<std::vector<Vec2>>;

/// A front 200 mm wide and 500 high, whose lines are only drawn.
pattern::Panel front_with(const Lines& lines) {
  pattern::Panel front = garments::piece("front", {{0, 0}, {200, 0}, {200, 500}, {0, 500}});
  for (const std::vector<Vec2>& points : lines)
    front.lines.push_back({"i" + std::to_string(front.lines.size()), points, true});
  return front;
}

/// A bust dart in its right side, 30 mm wide and 120 long.
const std::vector<Vec2> kBust{{200, 285}, {80, 300}, {200, 315}};

TEST(DrawnDarts, TwoLinesFromTheOutlineToAPointAreCutOut) {
  const pattern::Panel front = front_with({kBust});
  const std::vector<create::DrawnDart> darts = create::drawn_darts(front);
  ASSERT_EQ(darts.size(), 1u);
  const pattern::Panel cut = create::with_dart(front, darts[0]);
  ASSERT_TRUE(pattern::validate(cut));
  EXPECT_NEAR(pattern::signed_area(front.outline) - pattern::signed_area(cut.outline), 30 * 120 / 2, 1);
  EXPECT_TRUE(cut.lines.empty());
  ASSERT_EQ(cut.outline.edges.size(), 7u) << "the side in two, and the legs";
  EXPECT_NEAR(garments::length_of(cut, 0), 185, 0.1) << "from the dart up";
  EXPECT_NEAR(garments::length_of(cut, 5), std::hypot(120, 15), 0.1);
  EXPECT_NEAR(garments::length_of(cut, 6), std::hypot(120, 15), 0.1);
  EXPECT_EQ(cut.outline.edges[6].id, "e6");
}

TEST(DrawnDarts, LegsAreLinesOfTheirOwnWithOneInTheMiddleAsWell) {
  const Vec2 tip{80, 300};
  const std::vector<create::DrawnDart> darts =
      create::drawn_darts(front_with({{tip, {200, 315}}, {{200, 300}, tip}, {{200, 285}, tip}}));
  ASSERT_EQ(darts.size(), 1u);
  EXPECT_NEAR(length(darts[0].second - darts[0].first), 30, 0.1) << "the outermost two";
}

TEST(DrawnDarts, LegsThatGoOnIntoTheAllowanceEndAtTheOutline) {
  const std::vector<create::DrawnDart> darts =
      create::drawn_darts(front_with({{{212, 283.5}, {80, 300}, {212, 316.5}}}));
  ASSERT_EQ(darts.size(), 1u);
  EXPECT_NEAR(darts[0].first.x, 200, 0.1);
  EXPECT_NEAR(length(darts[0].second - darts[0].first), 30, 0.1);
}

TEST(DrawnDarts, TheCapThatTheOutlineHasAcrossTheMouthGoesWithIt) {
  pattern::Panel front =
      garments::piece("front", {{0, 0}, {200, 0}, {200, 285}, {205, 300}, {200, 315}, {200, 500}, {0, 500}});
  front.lines.push_back({"dart", kBust, true});
  const std::vector<create::DrawnDart> darts = create::drawn_darts(front);
  ASSERT_EQ(darts.size(), 1u);
  const pattern::Panel cut = create::with_dart(front, darts[0]);
  ASSERT_TRUE(pattern::validate(cut));
  EXPECT_NEAR(pattern::signed_area(cut.outline), 200 * 500 - 30 * 120 / 2, 1);
}

TEST(DrawnDarts, OtherLinesAreNone) {
  const auto none = [](const Lines& lines) { return create::drawn_darts(front_with(lines)).empty(); };
  EXPECT_TRUE(none({{{60, 400}, {60, 300}, {140, 300}, {140, 400}, {60, 400}}})) << "a pocket";
  EXPECT_TRUE(none({{{80, 500}, {80, 400}}, {{100, 500}, {100, 400}}})) << "a pleat";
  EXPECT_TRUE(none({{{200, 285}, {80, 300}, {150, 310}}})) << "one leg ends within";
  EXPECT_TRUE(none({{{200, 285}, {180, 300}, {200, 315}}})) << "a notch";
  EXPECT_TRUE(none({{{20, 500}, {100, 300}, {180, 500}}})) << "another neckline";
  EXPECT_TRUE(none({{{200, 285}, {80, 300}, {100, 500}}})) << "a flap: legs unlike";
  pattern::Panel sewn = front_with({kBust});
  sewn.lines[0].drawn = false;
  EXPECT_TRUE(create::drawn_darts(sewn).empty()) << "the mesh follows it";
}

TEST(DrawnDarts, EachOfSeveralIsCutOut) {
  pattern::Panel front = front_with({kBust, {{0, 285}, {60, 300}, {0, 315}}, {{90, 0}, {100, 90}, {110, 0}}});
  for (const create::DrawnDart& dart : create::drawn_darts(front)) front = create::with_dart(front, dart);
  ASSERT_TRUE(pattern::validate(front));
  EXPECT_EQ(front.outline.edges.size(), 4u + 3 * 3);
  EXPECT_NEAR(pattern::signed_area(front.outline), 200 * 500 - 30 * 120 / 2.0 - 30 * 60 / 2.0 - 20 * 90 / 2.0,
              2);
}

}  // namespace
}  // namespace toile
