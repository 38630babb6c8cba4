// Collars of garments that open below the neck.

#include "core/pattern/seams/open_collars.h"

#include <gtest/gtest.h>

#include "core/pattern/curve.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::strip;

/// A T-shirt's front and back, sleeves and a collar as long as their necks, 80 mm broad.
pattern::Pattern shirt(const std::vector<pattern::Panel>& more) {
  pattern::Pattern p;
  p.panels = {garments::plain_top("Front", 560), garments::plain_top("Back", 620),
              garments::plain_sleeve("Sleeve left"), garments::plain_sleeve("Sleeve right")};
  double neck = 0;
  for (const int panel : {0, 1}) neck += pattern::arc_length(p.panels[panel].outline.edges[4]);
  p.panels.push_back(strip("Collar", neck, 80));
  p.panels.insert(p.panels.end(), more.begin(), more.end());
  return p;
}

TEST(OpenCollars, APlacketKeepsACollarsEndsApartAndOpensItInFront) {
  const test::WornSeams closed(shirt({}).panels), open(shirt({strip("Placket", 160, 35)}).panels);
  const std::vector<std::string> end{"Collar.e1"}, other{"Collar.e3"};
  EXPECT_TRUE(closed.has(end, other)) << closed.text();
  EXPECT_FALSE(open.has(end, other)) << open.text();
  for (const char* name : {"Sleeve placket", "Placket binding"})
    EXPECT_FALSE(seams::has_open_neck(shirt({strip(name, 160, 35)}))) << name;
  const bool around = open.has({"Collar.e0"}, {"Front.e4", "Back.e4", "Front.e4"}) ||
                      open.has({"Collar.e2"}, {"Front.e4", "Back.e4", "Front.e4"});
  EXPECT_TRUE(around) << open.text();
}

TEST(OpenCollars, ABroadCollarOnAVStaysOpenAndABandThereDoesNot) {
  const auto closes = [](double breadth, bool v) {
    pattern::Pattern p;
    const double neck = v ? 480 : 630;
    p.panels = {garments::piece("Front", {{-250, 0},
                                          {250, 0},
                                          {245, 380},
                                          {200, 600},
                                          {70, 640},
                                          {0, neck},
                                          {-70, 640},
                                          {-200, 600},
                                          {-245, 380}}),
                garments::plain_top("Back", 620), strip("Collar", 800, breadth)};
    const seams::SeamModel m = seams::make_seam_model(p);
    return seams::closes_open_collar(m, {"s", {{2, 1}}, {{2, 3}}});
  };
  EXPECT_TRUE(closes(150, true));
  EXPECT_FALSE(closes(40, true)) << "a band";
  EXPECT_FALSE(closes(150, false)) << "a blunt corner is no V";
}

TEST(OpenCollars, BeginBetweenTwoFronts) {
  pattern::Pattern p;
  const std::vector<garments::Node> half{{0, 0}, {250, 0}, {245, 380}, {200, 600}, {70, 640}, {0, 560}};
  std::vector<garments::Node> other;
  for (auto n = half.rbegin(); n != half.rend(); ++n) other.push_back({-n->x, n->y});
  p.panels = {garments::piece("Front", half), garments::piece("Front_mirrored", other),
              garments::plain_top("Back", 620), strip("Collar", 400, 80)};
  const seams::SeamModel m = seams::make_seam_model(p);
  ASSERT_TRUE(m.open_neck);
  const Index left = 4, right = 0;  // necks
  const auto begun = [&](std::vector<pattern::SeamEdge> neck) {
    pattern::Seam seam{"s", std::move(neck), {{3, 0}}};
    seams::begin_in_front(m, seam);
    std::vector<Index> panels;
    for (const pattern::SeamEdge& e : seam.a) panels.push_back(e.panel);
    return panels;
  };
  EXPECT_EQ(begun({{2, 4}, {0, left}, {1, right}}), (std::vector<Index>{1, 2, 0}));
  EXPECT_EQ(begun({{1, right}, {2, 4}, {0, left}}), (std::vector<Index>{1, 2, 0}));
  EXPECT_EQ(begun({{2, 4}, {0, left}}), (std::vector<Index>{2, 0})) << "it does not go all around";
}

}  // namespace
}  // namespace toile
