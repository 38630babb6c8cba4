// Garments that close in themselves, and what is held by other than shoulders and waists.

#include <gtest/gtest.h>

#include <cmath>

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
