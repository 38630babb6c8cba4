// Cloth on a person that no seam joins, and the ground under what begins low.

#include <gtest/gtest.h>

#include "tests/core/drape/garments.h"
#include "tests/core/drape/heap.h"
#include "tests/core/drape/runs.h"

namespace toile {
namespace {

/// Sheets of 300 by 400 mm, upright before and behind the mannequin, the lower edge at `low` m.
drape::DrapeInput sheets(int count, double low) {
  pattern::Pattern pattern;
  for (int k = 0; k < count; ++k)
    pattern.panels.push_back(test::rectangle(k == 0 ? "front" : "back", 300, 400));
  drape::DrapeInput input = test::heap_of(std::move(pattern));
  for (int k = 0; k < count; ++k)
    input.placements[static_cast<std::size_t>(k)] =
        sewing::RigidPlacement{{0, low, k == 0 ? 0.25 : -0.3}, {}, false};
  input.settings.particle_distance = 0.04;
  input.settings.max_time = 2;
  return input;
}

double lowest(const drape::DrapeResult& r) { return bounding_box(r.positions).low.y; }

TEST(Unsewn, PiecesThatFallAreNotWorn) {
  const drape::DrapeResult r = draped(sheets(2, 0.8));
  EXPECT_EQ(r.worn, drape::Worn::kNo);
  const preflight::Finding* why = told(r.findings, preflight::FindingKind::kUnsewn);
  ASSERT_NE(why, nullptr);
  EXPECT_EQ(why->about.size(), 2U);
}

TEST(Unsewn, ASheetThatIsLaidOnSomebodyIsNothingToBeWorn) {
  drape::DrapeInput input = sheets(1, 0);
  const measure::BodyFigure& figure = test::person().figure;
  // Over the head, level.
  input.placements[0] = sewing::RigidPlacement{{0, figure.top + 0.01, 0.2}, {-1.5707963267948966, 0, 0}};
  input.settings.max_time = 0.5;
  const drape::DrapeResult r = draped(input);
  EXPECT_EQ(r.worn, drape::Worn::kNobody);
  EXPECT_EQ(told(r.findings, preflight::FindingKind::kUnsewn), nullptr);
}

TEST(Unsewn, ASheetOnTheGroundIsNotWorn) {
  drape::DrapeInput input = sheets(1, 0);
  input.placements[0] = sewing::RigidPlacement{{0, 0.03, 0.9}, {-1.5707963267948966, 0, 0}};
  const drape::DrapeResult r = draped(input);
  EXPECT_EQ(r.worn, drape::Worn::kNo);
  EXPECT_NE(told(r.findings, preflight::FindingKind::kOnGround), nullptr);
  EXPECT_EQ(told(r.findings, preflight::FindingKind::kUnsewn), nullptr) << "one sheet needs no seam";
}

TEST(LowGround, CarriesClothThatBeginsBelowTheFloor) {
  const drape::DrapeInput input = sheets(2, -0.1);
  const drape::DrapeResult r = draped(input);
  EXPECT_NEAR(lowest(r), -0.1, 0.01) << "it lies on ground where it began";
  const preflight::Finding* why = told(r.findings, preflight::FindingKind::kBelowFloor);
  ASSERT_NE(why, nullptr);
  EXPECT_NEAR(why->place.y, -0.1, 1e-6);
}

TEST(LowGround, IsTheFloorOtherwise) {
  const drape::DrapeResult r = draped(sheets(2, 0.2));
  EXPECT_GT(lowest(r), test::person().figure.floor);
  EXPECT_EQ(told(r.findings, preflight::FindingKind::kBelowFloor), nullptr);
}

}  // namespace
}  // namespace toile
