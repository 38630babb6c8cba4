// Garments that close in themselves, and what is held by other than shoulders and waists.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/arrange/garments.h"
#include "tests/core/arrange/started.h"

namespace toile {
namespace {

using namespace test;

/// A skirt of one piece that closes at the back, with a band of one piece. Nothing is named but the band.
pattern::Pattern tube_skirt() {
  pattern::Pattern pattern;
  pattern.panels = {polygon("p0", {{-520, 0}, {520, 0}, {375, 500}, {-375, 500}}),
                    polygon("waistband", {{0, 0}, {750, 0}, {750, 40}, {0, 40}})};
  pattern.seams = {seam("back", {{0, 1}}, {{0, 3}}), seam("band_back", {{1, 1}}, {{1, 3}}),
                   seam("waist", {{1, 0}}, {{0, 2}})};
  return pattern;
}

void expect_around(const Start& s) {
  const auto all = rings(s.assembly.garment);
  ASSERT_EQ(all.size(), 2U);
  for (const auto& ring : all) EXPECT_EQ(std::abs(winding(s, ring, {0, 1, 0}, {0, 1, 0})), 1);
}

TEST(ArrangeTubes, ASkirtOfOnePieceHangsFromItsBandAtTheWaist) {
  const Start s = started(tube_skirt());
  expect_clean(s);
  expect_around(s);
  EXPECT_NEAR(centre_of(s, 1).y, figure().waist, 0.08);
  EXPECT_LT(centre_of(s, 0).y, centre_of(s, 1).y - 0.2) << "the skirt below its band";
}

/// Half a disc: its cone would turn the ends of a straight band down, beside the hips.
TEST(ArrangeTubes, TheBandOfACircleSkirtStandsLevel) {
  pattern::Pattern pattern;
  std::vector<Vec2> outline;
  constexpr int kParts = 24;
  const auto at = [](double radius, int k) {
    const double angle = std::numbers::pi * (1 + static_cast<double>(k) / kParts);
    return Vec2{radius * std::cos(angle), radius * std::sin(angle)};
  };
  for (int k = 0; k <= kParts; ++k) outline.push_back(at(700, k));
  for (int k = kParts; k >= 0; --k) outline.push_back(at(250, k));
  pattern.panels = {polygon("skirt", outline), polygon("waistband", {{0, 0}, {785, 0}, {785, 60}, {0, 60}})};
  std::vector<pattern::SeamEdge> waist;
  for (Index k = kParts + 1; k < 2 * kParts + 1; ++k) waist.push_back({0, k});
  pattern.seams = {seam("back", {{0, kParts}}, {{0, 2 * kParts + 1}}), seam("band_back", {{1, 1}}, {{1, 3}})};
  pattern.seams.push_back({"waist", {{1, 0}}, waist, false});
  const Start s = started(pattern);
  expect_clean(s);
  expect_around(s);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (Index v = s.assembly.garment.first_vertex[1]; v < s.assembly.garment.first_vertex[2]; ++v) {
    low = std::min(low, s.assembly.positions[v].y);
    high = std::max(high, s.assembly.positions[v].y);
  }
  EXPECT_NEAR(high - low, 0.06, 5e-3) << "as high as it is wide";
  EXPECT_NEAR(0.5 * (high + low), figure().waist, 0.1);
}

TEST(ArrangeTubes, ASkirtOfOnePieceAloneHasItsUpperEndWhereTheTrunkIsAsWide) {
  for (const bool upside_down : {false, true}) {
    pattern::Pattern pattern = tube_skirt();
    pattern.panels.resize(1);
    pattern.seams.resize(1);
    if (upside_down) pattern.panels[0] = polygon("p0", {{-375, 0}, {375, 0}, {520, 500}, {-520, 500}});
    const Start s = started(pattern);
    expect_clean(s);
    expect_around(s);
    const double top = centre_of(s, 0).y + 0.27;  // its middle is nearer to the wider end
    EXPECT_NEAR(top, figure().waist, 0.1) << upside_down;
  }
}

/// Half of leggings: hem, back of the inner seam, back and front of the crotch with the waist between them,
/// front of the inner seam. The front lies towards larger x.
std::vector<Vec2> one_piece_leg(double hem) {
  return {{-hem, 0}, {hem, 0}, {225, 720}, {190, 780}, {185, 960}, {-200, 1000}, {-210, 800}, {-275, 720}};
}

/// Legs of one piece each, with a waistband and with cuffs of one piece.
pattern::Pattern leggings(double hem) {
  pattern::Pattern pattern;
  pattern.panels = {polygon("leg_a", one_piece_leg(hem)), turned_over("leg_b", one_piece_leg(hem)),
                    polygon("waistband", {{0, 0}, {700, 0}, {700, 40}, {0, 40}}),
                    polygon("cuff_a", {{0, 0}, {230, 0}, {230, 60}, {0, 60}}),
                    polygon("cuff_b", {{0, 0}, {230, 0}, {230, 60}, {0, 60}})};
  pattern.seams = {seam("inner_a", {{0, 1}}, {{0, 7}}),     seam("inner_b", {{1, 6}}, {{1, 0}}),
                   seam("front_below", {{0, 2}}, {{1, 5}}), seam("front", {{0, 3}}, {{1, 4}}),
                   seam("back", {{0, 5}}, {{1, 2}}),        seam("back_below", {{0, 6}}, {{1, 1}}),
                   seam("band", {{2, 1}}, {{2, 3}}),        seam("waist", {{2, 0}}, {{0, 4}, {1, 3}}),
                   seam("round_a", {{3, 1}}, {{3, 3}}),     seam("round_b", {{4, 1}}, {{4, 3}}),
                   seam("hem_a", {{3, 2}}, {{0, 0}}),       seam("hem_b", {{4, 2}}, {{1, 7}})};
  return pattern;
}

TEST(ArrangeTubes, LegsOfOnePieceGoAroundTheirLegs) {
  for (const double hem : {100.0, 180.0}) {  // as leggings and as pyjamas
    const Start s = started(leggings(hem));
    const measure::BodyFigure& f = figure();
    // Seen from outside with the waist up, the front of a left leg is on the left.
    const Vec3 a = centre_of(s, 0), b = centre_of(s, 1);
    EXPECT_LT(a.x, f.middle - 0.05) << "its front is on the right: the wearer's right leg";
    EXPECT_NEAR(b.x - f.middle, f.middle - a.x, 0.02);
    EXPECT_NEAR(b.y, a.y, 0.01);
    EXPECT_GT(centre_of(s, 2).y, f.hip) << "the band";
    for (const Index cuff : {3, 4}) {
      const measure::LegLine& leg = f.leg[cuff == 3 ? measure::kWearersRight : measure::kWearersLeft];
      EXPECT_NEAR(centre_of(s, cuff).x, leg.ankle.x, 0.06);
      EXPECT_NEAR(centre_of(s, cuff).y, leg.ankle.y, 0.15);
    }
    int around_leg = 0;
    for (const auto& ring : rings(s.assembly.garment))
      for (const measure::LegLine& leg : f.leg)
        around_leg += std::abs(winding(s, ring, leg.ankle, normalized(leg.knee - leg.ankle)));
    EXPECT_GE(around_leg, 2) << "the lower ends of both";
  }
}

TEST(ArrangeTubes, LegsShorterThanTheyAreWideStandSomewhere) {
  pattern::Pattern pattern = leggings(300);
  const std::vector<Vec2> shorts{{-300, 700}, {300, 700},   {225, 720},  {190, 780},
                                 {185, 960},  {-200, 1000}, {-210, 800}, {-275, 720}};
  pattern.panels[0] = polygon("leg_a", shorts);
  pattern.panels[1] = turned_over("leg_b", shorts);
  const Start s = started(pattern);
  for (const Vec3& p : s.assembly.positions) {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    ASSERT_LT(length(p - Vec3{0, figure().crotch, 0}), 1.5);
  }
}

TEST(ArrangeTubes, ABandDownOpenFrontsLiesAroundTheNeckWhateverItIsCalled) {
  pattern::Pattern pattern;
  const std::vector<Vec2> left{{0, 0}, {250, 0}, {230, 400}, {185, 600}, {80, 640}, {0, 430}};
  pattern.panels = {
      polygon("Back",
              {{-250, 0}, {250, 0}, {230, 400}, {185, 600}, {80, 640}, {-80, 640}, {-185, 600}, {-230, 400}}),
      polygon("Front", left), turned_over("Front_2", left),
      polygon("Front Band", {{0, 0}, {1470, 0}, {1470, 40}, {0, 40}})};
  pattern.seams = {seam("side_l", {{0, 7}}, {{1, 1}}), seam("side_r", {{0, 1}}, {{2, 4}}),
                   seam("shoulder_l", {{0, 5}}, {{1, 3}}), seam("shoulder_r", {{0, 3}}, {{2, 2}}),
                   seam("around", {{3, 0}}, {{2, 0}, {2, 1}, {0, 4}, {1, 4}, {1, 5}})};
  const Start s = started(pattern);
  EXPECT_EQ(s.made.pieces[3].where, "collar, around the neck");
  for (const Index front : {1, 2})
    EXPECT_LT(std::abs(centre_of(s, front).x), 0.2) << "no room is made for it";
}

TEST(ArrangeTubes, DungareesAreHeldByTheirCrotchHoweverHighTheBibIs) {
  pattern::Pattern pattern = trousers();
  const double waist = centre_of(started(pattern), 0).y;
  const std::vector<Vec2> bib{{-130, 0}, {130, 0}, {100, 250}, {-100, 250}};
  pattern.panels.push_back(polygon("bib", bib));
  // The fronts' waists, 235 mm each, take the bib at their inner parts.
  pattern::SeamEdge left{1, 1}, right{0, 3};
  right.to = 130.0 / 235;
  left.from = 1 - 130.0 / 235;
  pattern.seams.push_back(seam("bib", {{4, 0}}, {left, right}));
  const Start s = started(pattern);
  EXPECT_NEAR(centre_of(s, 0).y, waist, 0.05);
  EXPECT_GT(centre_of(s, 4).y, centre_of(s, 0).y + 0.3);
}

}  // namespace
}  // namespace toile
