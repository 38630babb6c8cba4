// Fronts that lie over each other, and the bands above them.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/pattern/validate.h"
#include "core/project/create/underlaps.h"
#include "core/project/create/wraps.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::piece;
using garments::strip;
using Panels = std::vector<pattern::Panel>;

/// 620 mm long, half a back and `lap` mm wide, its middle drawn from `from` to `to` mm above the hem.
pattern::Panel front(const std::string& name, double lap, double from = 0, double to = 620) {
  pattern::Panel panel = piece(name, {{-lap, 0}, {300, 0}, {240, 620}, {-lap, 620}});
  panel.lines.push_back({"i0", {{0, from}, {0, to}}, true});
  return panel;
}

Panels skirt(const pattern::Panel& front_panel) {
  return {front_panel, piece("Skirt back", {{-300, 0}, {300, 0}, {240, 620}, {-240, 620}})};
}

TEST(Wraps, EndInTheMiddleThatIsDrawnOnThem) {
  for (const double short_by : {0.0, 20.0}) {
    const Panels panels = skirt(front("Skirt front", 150, short_by, 620 - short_by));
    const auto found = create::wraps(panels, std::vector<char>{1, 0});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].panel, 0);
    EXPECT_NEAR(found[0].long_as, 150, 1e-6);
    const pattern::Panel rest = create::folded(panels[0], found[0].middle);
    ASSERT_TRUE(pattern::validate(rest).ok());
    for (const pattern::PanelEdge& edge : rest.outline.edges) {
      EXPECT_GT(edge.curves[0].p0.x, -1e-6);
      EXPECT_NE(edge.id, pattern::kFoldEdge) << "the fronts are sewn there";
    }
  }
}

TEST(Wraps, AreNoneWhereTheFrontIsNoWiderThanHalfABackOrTheLineIsAnother) {
  const auto count = [](const pattern::Panel& panel, char pair = 1) {
    return create::wraps(skirt(panel), std::vector<char>{pair, 0}).size();
  };
  EXPECT_EQ(count(front("Skirt front", 150)), 1u);
  EXPECT_EQ(count(front("Skirt front", 40)), 0u) << "a button stand";
  EXPECT_EQ(count(front("Skirt front", 300)), 0u) << "too far";
  EXPECT_EQ(count(front("Skirt front", 150), 0), 0u) << "cut once";
  EXPECT_EQ(count(front("Skirt front", 150, 60, 560)), 0u) << "a line within the piece";
  pattern::Panel slanted = front("Skirt front", 150);
  slanted.lines[0].points = {{0, 0}, {140, 620}};
  EXPECT_EQ(count(slanted), 0u);
  pattern::Panel design = front("Skirt front", 0);
  design.lines[0].points = {{100, 0}, {100, 620}};
  EXPECT_EQ(count(design), 0u) << "what stays would be a third of the back";
  EXPECT_EQ(count(front("Sleeve", 150)), 0u);
}

TEST(Wraps, BandsAboveThemEndAtThePairOfNotchesNearestToTheirEnds) {
  const auto ends_of = [](const std::vector<double>& notches) {
    pattern::Panel band = strip("Waistband", 1050, 40);
    for (const double x : notches) band.notches.push_back({{x, 0}, 0, {}});
    return create::wrapped_ends(Panels{band});
  };
  const auto ends = ends_of({160, 340, 525, 710, 892});
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR(ends[0].long_as, 160, 1e-6);
  EXPECT_NEAR(ends[1].long_as, 158, 1e-6);
  EXPECT_LT(ends[0].away.x * ends[1].away.x, 0) << "one at either end";
  EXPECT_TRUE(ends_of({160, 525}).empty());
  EXPECT_TRUE(ends_of({300, 750}).empty());
  EXPECT_TRUE(ends_of({}).empty());
}

}  // namespace
}  // namespace toile
