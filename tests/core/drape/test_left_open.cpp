// A garment of which a seam cannot be sewn: it is left open and named, and the rest is draped.

#include "core/drape/left_open.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/drape/pipeline.h"
#include "core/drape/worn_part.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

/// The tube, with a third seam of its hems: 30 mm of the front's to the whole of the back's.
drape::DrapeInput tube_with_a_seam_of_1_to_8() {
  drape::DrapeInput input = test::tube();
  input.pattern.seams.push_back({"hem", {{0, 0, false, 0.4, 0.5}}, {{1, 0, false}}, true});
  input.settings.max_time = 1.2;
  return input;
}

TEST(LeftOpen, ASeamThatCannotBeGatheredIsNamedAndTheRestIsDraped) {
  const drape::DrapeInput input = drape::worn_part(tube_with_a_seam_of_1_to_8());
  const auto run = drape::drape(input, {}, nullptr);
  ASSERT_TRUE(run) << run.error().message;
  ASSERT_FALSE(run->open_seams.empty());
  EXPECT_EQ(run->open_seams.back().id, "hem");
  EXPECT_GT(run->open_seams.back().gap, 0.02) << "front and back hang on two sides of the column";
  EXPECT_FALSE(run->settled());
  EXPECT_EQ(run->worst.cloth_body + run->worst.cloth_cloth, 0);
  const auto told = std::find_if(run->findings.begin(), run->findings.end(), [](const preflight::Finding& f) {
    return f.kind == preflight::FindingKind::kLengthRatio;
  });
  ASSERT_NE(told, run->findings.end());
  EXPECT_EQ(told->severity, preflight::Severity::kWarning);
  EXPECT_EQ(preflight::where_text(*told), "seam hem");
}

TEST(LeftOpen, ADrapeThatComesToRestEndsWithTheSeamOpen) {
  drape::DrapeInput input = drape::worn_part(tube_with_a_seam_of_1_to_8());
  input.settings.max_time = 20;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(r.stop_reason.kind, drape::Stop::kOpenSeam);
  EXPECT_EQ(r.stop_reason.name, "hem");
}

TEST(LeftOpen, OtherSeamsStay) {
  const drape::DrapeInput input = drape::worn_part(tube_with_a_seam_of_1_to_8());
  EXPECT_EQ(input.pattern.seams.size(), 2U);
  ASSERT_EQ(input.left_open.size(), 1U);
  EXPECT_TRUE(drape::worn_part(test::tube()).left_open.empty());
}

/// Where every seam is wrong, the units are: there is nothing to drape.
TEST(LeftOpen, AGarmentThatFallsApartWithoutSuchSeamsIsRefusedAsBefore) {
  drape::DrapeInput input = test::tube();
  input.pattern.panels[0] = test::rectangle("front", 260, 40);
  input.pattern.panels[1] = test::rectangle("back", 260, 160);
  input = drape::worn_part(std::move(input));
  EXPECT_TRUE(input.left_open.empty());
  const auto run = drape::drape(input, {}, nullptr);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, "seam.length_ratio");
}

TEST(LeftOpen, GoesWithAPieceThatIsLeftOut) {
  const drape::DrapeInput input = drape::worn_part(tube_with_a_seam_of_1_to_8());
  EXPECT_TRUE(drape::with_panels(input, {0}).left_open.empty());
  EXPECT_EQ(drape::with_panels(input, {0, 1}).left_open.size(), 1U);
}

}  // namespace
}  // namespace toile
