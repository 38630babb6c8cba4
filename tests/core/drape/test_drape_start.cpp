// From an input to what a drape begins with, where a person wears it.

#include "core/drape/drape_start.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/dressing/certificate.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/drape/heap.h"

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

}  // namespace
}  // namespace toile
