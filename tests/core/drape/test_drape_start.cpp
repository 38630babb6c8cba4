// From an input to what a drape begins with, where a person wears it.

#include "core/drape/drape_start.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/dressing/certificate.h"
#include "core/dressing/put_on.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/drape/heap.h"
#include "tests/core/drape/runs.h"

namespace toile {
namespace {

/// A front, a back and two sleeves, all in one place at the mannequin's feet.
drape::DrapeInput heap() { return test::heap_of(test::shirt()); }

drape::DrapeStart started(const drape::DrapeInput& input) {
  drape::DrapeStart start = drape::prepare_start(input, {}).value();
  drape::dress_start(input, start, {});
  return start;
}

TEST(DrapeStart, PiecesInAHeapAreArrangedAnewAndPutOn) {
  const drape::DrapeInput input = heap();
  const drape::DrapeStart start = started(input);
  ASSERT_TRUE(start.dressed.has_value());
  EXPECT_FALSE(preflight::first_error(start.findings)) << "where they were placed does not matter any more";
  const auto rings = dressing::worn_rings(start.placed.garment, start.dressed->positions,
                                          dressing::skeleton_of(start.person->figure));
  EXPECT_EQ(rings.size(), 4U) << "neck, hem and two cuffs";
  for (const dressing::WornRing& ring : rings) EXPECT_TRUE(ring.right);
}

/// As a pattern's drawing has them, side by side from her side on.
TEST(DrapeStart, PiecesInARowBesideHerAreArrangedBeforeAnyWayIsTriedFromThere) {
  drape::DrapeInput input = heap();
  double x = 1;
  for (sewing::Placement& place : input.placements) {
    place = sewing::RigidPlacement{{x, 0.8, 0.3}, {}, false};
    x += 0.8;
  }
  const drape::DrapeStart start = started(input);
  ASSERT_TRUE(start.dressed.has_value());
  const auto ways = static_cast<int>(dressing::dressing_ways().size());
  EXPECT_GT(start.dressed->start, ways) << "of the ways from where pieces are arranged";
  const drape::DrapeStart heaped = started(heap());
  EXPECT_EQ(start.dressed->positions, heaped.dressed.value().positions) << "as from any other place";
}

TEST(DrapeStart, WhoWantsThemSewnFromThereIsToldWhatHindersIt) {
  drape::DrapeInput input = heap();
  input.settings.dress = false;
  const drape::DrapeStart start = started(input);
  EXPECT_FALSE(start.dressed.has_value());
  EXPECT_TRUE(preflight::first_error(start.findings));
}

TEST(DrapeStart, ACancelledOneIsNotPutOn) {
  const drape::DrapeInput input = heap();
  drape::DrapeStart start = drape::prepare_start(input, {}).value();
  const std::atomic<bool> cancel{true};
  drape::dress_start(input, start, {{}, &cancel});
  EXPECT_FALSE(start.dressed.has_value());
}

TEST(DrapeStart, TellsOfABodyThatLooksToTheBack) {
  drape::DrapeInput input = test::heap_of(test::skirt());
  const auto is_told = [&] {
    const preflight::Findings findings = drape::prepare_start(input, {}).value().findings;
    return told(findings, preflight::FindingKind::kBodyTurned) != nullptr;
  };
  EXPECT_FALSE(is_told());
  for (Vec3& p : input.bodies[0].mesh.vertices) p = {-p.x, p.y, -p.z};
  EXPECT_TRUE(is_told());
}

}  // namespace
}  // namespace toile
