// Fronts of trousers that are drawn without their corner at a pocket.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/validate.h"
#include "core/project/create/pocket_corners.h"
#include "tests/core/project/create/slashed_trousers.h"

namespace toile {
namespace {

TEST(PocketCorners, AFrontThatIsCutAwayAtAPocketIsDrawnWhole) {
  const pattern::Panel facing = garments::piece("Pocket facing", {{0, 0}, {60, 0}, {60, 200}, {0, 200}});
  const std::vector<pattern::Panel> panels{garments::slashed_front(840), garments::back_of_trousers(1000),
                                           facing};
  const std::vector<create::PocketCorner> corners = create::pocket_corners(panels);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0].panel, 0);
  EXPECT_EQ(corners[0].mouth, 2);
  EXPECT_NEAR(corners[0].corner.x, 220, 1e-6);
  EXPECT_NEAR(corners[0].corner.y, 1000, 1e-6);
  const pattern::Panel whole = create::with_corner(panels[0], corners[0]);
  ASSERT_EQ(whole.outline.edges.size(), 5u);
  EXPECT_TRUE(pattern::validate(whole).ok());
  EXPECT_NEAR(garments::length_of(whole, 1), 1000, 1e-6);
  EXPECT_NEAR(garments::length_of(whole, 2), 220, 1e-6);
}

TEST(PocketCorners, ACrotchThatFacesUpALittleIsNoPocket) {
  const pattern::Panel facing = garments::piece("Pocket facing", {{0, 0}, {60, 0}, {60, 200}, {0, 200}});
  pattern::Panel front = garments::piece(
      "Front",
      {{-60, 770}, {0, 0}, {220, 0}, {220, 840}, {180, 1000}, {30, 1000, Vec2{30, 900}, Vec2{10, 800}}});
  const std::vector<create::PocketCorner> corners =
      create::pocket_corners(std::vector{front, garments::back_of_trousers(1000), facing});
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0].mouth, 3) << "although the inner edge comes first";
}

TEST(PocketCorners, WhereNothingFillsItOrSidesAgreeAFrontStaysAsItIsDrawn) {
  const pattern::Panel facing = garments::piece("Pocket facing", {{0, 0}, {60, 0}, {60, 200}, {0, 200}});
  EXPECT_TRUE(
      create::pocket_corners(std::vector{garments::slashed_front(840), garments::back_of_trousers(1000)})
          .empty());
  EXPECT_TRUE(create::pocket_corners(
                  std::vector{garments::slashed_front(840), garments::back_of_trousers(840), facing})
                  .empty());
}

/// As slashed_front(), its side running on into the mouth without a corner: one edge.
pattern::Panel smooth_front() {
  pattern::Panel front = garments::slashed_front(840);
  std::vector<pattern::PanelEdge>& edges = front.outline.edges;
  edges[1].curves.push_back(edges[2].curves[0]);
  edges.erase(edges.begin() + 2);
  return front;
}

/// Goes as far beyond the mouth as the front lacks, and below the front behind it.
pattern::Panel facing_with_mouth(Vec2 from, Vec2 to) {
  pattern::Panel facing = garments::piece("Pocket facing", {{0, 0}, {40, -20}, {40, 160}, {-60, 160}});
  facing.lines = {{"mouth", {from, to}, true}};
  return facing;
}

TEST(PocketCorners, OutlinesStayClosedWhereAMouthIsOfSeveralCurves) {
  const pattern::Panel facing = garments::piece("Pocket facing", {{0, 0}, {60, 0}, {60, 200}, {0, 200}});
  for (const double at : {0.1, 1.0 / 3, 0.7}) {
    pattern::Panel front = garments::slashed_front(840);
    const auto [first, second] = pattern::split(front.outline.edges[2].curves[0], at);
    front.outline.edges[2].curves = {first, second};
    const std::vector<pattern::Panel> panels{front, garments::back_of_trousers(1000), facing};
    const std::vector<create::PocketCorner> corners = create::pocket_corners(panels);
    ASSERT_EQ(corners.size(), 1u);
    EXPECT_TRUE(pattern::validate(create::with_corner(front, corners[0]))) << at;
  }
}

TEST(PocketCorners, TheLineOnAFacingTellsWhereASmoothMouthBegins) {
  for (const bool over : {false, true}) {
    std::vector<pattern::Panel> panels{smooth_front(), garments::back_of_trousers(1000),
                                       facing_with_mouth({40, 0}, {0, 160})};
    if (over) panels[0] = garments::mirrored(panels[0], "Front");
    const std::vector<create::PocketCorner> corners = create::pocket_corners(panels);
    ASSERT_EQ(corners.size(), 1u) << over;
    EXPECT_NEAR(corners[0].corner.x, over ? -220 : 220, 0.1);
    EXPECT_NEAR(corners[0].corner.y, 1000, 0.1);
    const pattern::Panel whole = create::with_corner(panels[0], corners[0]);
    EXPECT_TRUE(pattern::validate(whole).ok());
    ASSERT_EQ(whole.outline.edges.size(), 5u) << "the mouth was none";
    for (std::size_t e = 0; e < 5; ++e) {
      const double length = garments::length_of(whole, static_cast<int>(e));
      const std::string& id = whole.outline.edges[e].id;
      if (id == "e1" || id == "e3") {
        EXPECT_NEAR(length, id == "e1" ? 1000 : 220, 0.2) << "side, waist";
      }
    }
  }
}

TEST(PocketCorners, AFacingKnowsHowTheHipIsCurvedAboveAMouth) {
  pattern::Panel facing = garments::piece("Pocket facing", {{-30, -10}, {41, -20}, {32, 160}, {-60, 160}});
  facing.lines = {{"mouth", {{40, 0}, {0, 160}}, true}};
  const std::vector<create::PocketCorner> corners = create::pocket_corners(
      std::vector{garments::slashed_front(840), garments::back_of_trousers(1000), facing});
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_NEAR(corners[0].corner.x, 212, 0.1) << "where side and waist run on straight it is 220";
  EXPECT_NEAR(corners[0].corner.y, 1000, 0.1);
}

TEST(PocketCorners, AFacingThatGoesOnElsewhereTellsNothing) {
  const pattern::Panel back = garments::back_of_trousers(1000), front = smooth_front();
  const pattern::Panel fits = facing_with_mouth({40, 0}, {0, 160});
  EXPECT_EQ(create::pocket_corners(std::vector{front, back, fits}).size(), 1u);
  EXPECT_TRUE(create::pocket_corners(std::vector{front, garments::back_of_trousers(960), fits}).empty())
      << "the back's side is shorter";
  const pattern::Panel bent = facing_with_mouth({40, 60}, {-40, 160});
  EXPECT_TRUE(create::pocket_corners(std::vector{front, back, bent}).empty()) << "its corner is off the side";
  pattern::Panel plain = fits;
  plain.lines.clear();
  EXPECT_TRUE(create::pocket_corners(std::vector{front, back, plain}).empty());
}

}  // namespace
}  // namespace toile
