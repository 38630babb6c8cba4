// Waistbands in halves of which one laps over the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "core/pattern/validate.h"
#include "core/project/create/underlaps.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::strip;

pattern::Panel with_notches(pattern::Panel band, std::vector<double> at) {
  const double low = band.outline.edges[0].curves[0].p0.y;
  for (const double x : at) band.notches.push_back({{x, low}, 0, {}});
  return band;
}

std::vector<create::Underlap> underlaps_of(const std::vector<pattern::Panel>& panels) {
  return create::underlaps(panels);
}

TEST(Underlaps, AreCutOffAtTheNotch) {
  const pattern::Panel left = strip("Waistband left", 440, 40);
  for (const bool far : {true, false}) {
    const pattern::Panel right = with_notches(strip("Waistband right", 480, 40), {far ? 440.0 : 40.0});
    const auto found = underlaps_of({left, right});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].panel, 1);
    EXPECT_NEAR(found[0].long_as, 40, 1e-6);
    const std::optional<pattern::Panel> cut = create::without_underlap(right, found[0]);
    ASSERT_TRUE(cut && pattern::validate(*cut).ok());
    const pattern::Panel& rest = *cut;
    ASSERT_EQ(rest.outline.edges.size(), 4u);
    for (int e = 0; e < 4; ++e) {
      EXPECT_EQ(rest.outline.edges[e].id, right.outline.edges[e].id);
      EXPECT_NEAR(garments::length_of(rest, e), e % 2 == 0 ? 440 : 40, 0.1);
    }
    EXPECT_TRUE(rest.notches.empty()) << "it is a corner now";
    double high = 0;
    for (const pattern::PanelEdge& edge : rest.outline.edges) high = std::max(high, edge.curves[0].p0.x);
    EXPECT_NEAR(high, far ? 440 : 480, 0.1) << "the end at the notch is gone";
  }
}

TEST(Underlaps, StayWhereTheEndSlantsByMoreThanThem) {
  const pattern::Panel left = strip("Waistband left", 1500, 40);
  const pattern::Panel slanted =
      garments::piece("Waistband right", {{0, 0}, {1495, 0}, {1520, 40}, {25, 40}});
  const auto found = underlaps_of({left, slanted});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(create::without_underlap(slanted, found[0]));
}

TEST(Underlaps, OfABandAllAroundLiesBeyondTheOnlyNotchNearAnEnd) {
  for (const bool far : {true, false}) {
    const auto found =
        underlaps_of({with_notches(strip("Waistband", 790, 35), {far ? 750.0 : 40.0, 230, 395, 560})});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].long_as, 40, 1e-6);
    EXPECT_NEAR(found[0].away.x, far ? 1 : -1, 1e-6);
  }
  EXPECT_TRUE(underlaps_of({with_notches(strip("Waistband", 790, 35), {40, 750})}).empty()) << "at both ends";
  EXPECT_TRUE(underlaps_of({with_notches(strip("Waistband", 790, 35), {0, 190, 395, 790})}).empty());
  EXPECT_TRUE(underlaps_of({with_notches(strip("Waistband", 790, 35), {8, 40})}).empty()) << "two marks";
}

TEST(Underlaps, AreNoneWhereNothingTellsThem) {
  const pattern::Panel left = strip("Waistband left", 440, 40);
  EXPECT_EQ(underlaps_of({left, strip("Waistband right", 480, 40)}).size(), 1u) << "both ends look alike";
  EXPECT_TRUE(underlaps_of({left, strip("Waistband right", 440, 40)}).empty());
  EXPECT_TRUE(underlaps_of({left, strip("Waistband right", 540, 40)}).empty()) << "too long for a lap";
  EXPECT_TRUE(underlaps_of({left, strip("Waistband right", 480, 60)}).empty()) << "another band";
  EXPECT_TRUE(underlaps_of({left, with_notches(strip("Waistband right", 480, 40), {200})}).empty())
      << "which end is not told";
  EXPECT_TRUE(underlaps_of({strip("Cuff left", 440, 40), strip("Cuff right", 480, 40)}).empty());
}

}  // namespace
}  // namespace toile
