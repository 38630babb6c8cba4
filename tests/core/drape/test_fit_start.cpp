// Garments that a person cannot wear as a whole: a seam is missing, or a part cannot be put on.

#include "core/drape/fit_start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/arrange/arrange.h"
#include "core/drape/pipeline.h"
#include "core/dressing/dress.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/drape/heap.h"
#include "tests/core/drape/runs.h"

namespace toile {
namespace {

pattern::Pattern without_seam(pattern::Pattern pattern, const std::string& id) {
  std::erase_if(pattern.seams, [&](const pattern::Seam& s) { return s.id == id; });
  return pattern;
}

/// A shirt with a left sleeve that narrows to 8 cm around: no hand passes.
drape::DrapeInput shirt_with_a_shut_sleeve() {
  pattern::Pattern shirt = test::shirt();
  shirt.panels[2] = test::polygon("sleeve_a", {{-40, -250}, {40, -250}, {175, 90}, {0, 235}, {-175, 90}});
  drape::DrapeInput input = test::heap_of(std::move(shirt));
  input.fabrics[0].stretch_weft = input.fabrics[0].stretch_warp = 4000;
  input.settings.particle_distance = 0.03;
  return input;
}

TEST(FitStart, AGarmentWithASlitIsPutOn) {
  const drape::DrapeInput input = test::heap_of(without_seam(test::shirt(), "cap_left_front"));
  drape::DrapeStart start = drape::prepare_start(input, {}).value();
  const drape::FittedStart fitted = drape::fit_start(input, start, {});
  EXPECT_TRUE(start.dressed.has_value());
  EXPECT_FALSE(fitted.reduced.has_value());
}

TEST(FitStart, ASlitIsToldAndTheGarmentWornInPart) {
  drape::DrapeInput input = test::heap_of(without_seam(test::shirt(), "cap_left_front"));
  input.settings.max_time = 1.5;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(r.worn, drape::Worn::kPartly);
  EXPECT_TRUE(told(r.findings, preflight::FindingKind::kSlit));
  EXPECT_FALSE(told(r.findings, preflight::FindingKind::kRingOff));
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
}

TEST(FitStart, APartThatCannotBePutOnIsLeftOutAndNamed) {
  const drape::DrapeInput input = shirt_with_a_shut_sleeve();
  drape::DrapeStart start = drape::prepare_start(input, {}).value();
  const drape::FittedStart fitted = drape::fit_start(input, start, {});
  ASSERT_TRUE(fitted.reduced.has_value());
  EXPECT_EQ(fitted.left_out, (std::vector<bool>{false, false, true, false}));
  ASSERT_EQ(fitted.reduced->left_out.size(), 1U);
  EXPECT_EQ(fitted.reduced->left_out[0].id, "sleeve_a");
  EXPECT_TRUE(fitted.reduced->left_out[0].tried);
  EXPECT_FALSE(preflight::first_error(start.findings));
  EXPECT_TRUE(told(start.findings, preflight::FindingKind::kLeftOut));
}

TEST(FitStart, ADrapeOfAPartGoesOnFromItsCheckpoint) {
  drape::DrapeInput input = shirt_with_a_shut_sleeve();
  input.settings.max_time = 0.7;
  const auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  ASSERT_TRUE(run->reduced());
  run->advance(300, {});
  const auto resumed = drape::DrapeRun::resume(input, run->checkpoint(), {}, nullptr).value();
  ASSERT_TRUE(resumed->reduced());
  for (auto* r : {run.get(), resumed.get()}) r->advance(std::numeric_limits<int>::max(), {});
  const drape::DrapeResult whole = run->conclude(), broken = resumed->conclude();
  EXPECT_EQ(whole.positions, broken.positions);
  EXPECT_EQ(whole.worn, drape::Worn::kPartly);
  EXPECT_EQ(broken.worn, drape::Worn::kPartly);
}

/// 24 cm around, before and behind the trunk.
drape::DrapeInput narrow_tube() {
  pattern::Pattern narrow = test::strapless();
  const std::vector<Vec2> strip{{-60, 0}, {60, 0}, {60, 300}, {-60, 300}};
  narrow.panels = {test::polygon("bodice_front", strip), test::polygon("bodice_back", strip)};
  drape::DrapeInput input = test::heap_of(std::move(narrow));
  const double height = test::person().figure.waist - 0.2;
  input.placements = {sewing::RigidPlacement{{0, height, 0.2}, {}, false},
                      sewing::RigidPlacement{{0, height, -0.2}, {0, 3.14159265358979, 0}, false}};
  return input;
}

TEST(FitStart, WhatNobodyCanPutOnIsRefused) {
  const drape::DrapeInput input = narrow_tube();
  drape::DrapeStart start = drape::prepare_start(input, {}).value();
  ASSERT_TRUE(preflight::first_error(start.findings));
  const drape::FittedStart fitted = drape::fit_start(input, start, {});
  EXPECT_FALSE(fitted.reduced.has_value());
  EXPECT_TRUE(preflight::first_error(start.findings));
  EXPECT_FALSE(told(start.findings, preflight::FindingKind::kGivenUp)) << "all ways were tried";
}

TEST(FitStart, WhatIsArrangedAlreadyIsNotTriedAgainFromThere) {
  drape::DrapeInput input = narrow_tube();
  const drape::DrapeStart flat = drape::prepare_start(input, {}).value();
  input.placements = arrange::arrange({input.pattern, flat.meshes, input.bodies}).value().placements;
  const drape::DrapeStart start = drape::prepare_start(input, {}).value();
  const auto ways = static_cast<int>(dressing::dressing_ways().size());
  const drape::PutOnTries all = drape::put_on_after(drape::kSewnInPlace, input, start, {});
  ASSERT_FALSE(all.on.has_value());
  EXPECT_LE(all.nearest, ways) << "of the ways from where the pieces stand";
  EXPECT_FALSE(all.gave_up);
  // With work for one way the others are not reached, nor forgotten.
  const drape::PutOnTries few =
      drape::put_on_after(drape::kSewnInPlace, input, start, {}, dressing::Effort(1));
  EXPECT_TRUE(few.gave_up);
  const drape::PutOnTries none = drape::put_on_after(ways, input, start, {});
  EXPECT_FALSE(none.on.has_value());
  EXPECT_TRUE(none.at_fault.empty()) << "nothing was tried";
}

/// What cannot be put on costs a bounded work, and that there was more to try is told.
TEST(FitStart, WhereTheWorkIsSpentItIsGivenUpAndTold) {
  const drape::DrapeInput input = narrow_tube();
  drape::DrapeStart start = drape::prepare_start(input, {}).value();
  drape::fit_start(input, start, {}, dressing::Effort(1));
  EXPECT_TRUE(preflight::first_error(start.findings));
  EXPECT_TRUE(told(start.findings, preflight::FindingKind::kGivenUp));
}

/// A strapless bodice around the trunk, and a strip sewn to its front that stands within the trunk.
TEST(FitStart, WithoutWhatStandsInTheWayTheRestIsSewnFromWhereItStands) {
  drape::DrapeInput input = test::heap_of(test::strapless());
  const drape::DrapeStart flat = drape::prepare_start(input, {}).value();
  input.placements = arrange::arrange({input.pattern, flat.meshes, input.bodies}).value().placements;
  pattern::Panel strip = test::polygon("frill", {{0, 0}, {200, 0}, {200, 60}, {0, 60}});
  input.pattern.panels.push_back(strip);
  const auto added = static_cast<Index>(input.pattern.panels.size()) - 1;
  input.pattern.seams.push_back({"frill", {{added, 0}}, {{0, 2, false, 0.3, 0.7}}});
  input.placements.push_back(sewing::RigidPlacement{{-0.1, test::person().figure.waist + 0.1, 0}, {}, false});
  input.fabric_of_panel.assign(input.pattern.panels.size(), 0);
  drape::DrapeStart start = drape::prepare_start(input, {}).value();
  ASSERT_TRUE(preflight::first_error(start.findings));
  const std::optional<drape::FittedStart> fitted = drape::without_refused(input, start, {});
  ASSERT_TRUE(fitted.has_value());
  EXPECT_EQ(fitted->left_out, (std::vector<bool>{false, false, true}));
  ASSERT_TRUE(fitted->reduced.has_value());
  EXPECT_EQ(fitted->reduced->pattern.seams.size(), 2U);
  EXPECT_FALSE(preflight::first_error(start.findings));
  EXPECT_TRUE(told(start.findings, preflight::FindingKind::kLeftOut));

  drape::DrapeInput narrow = narrow_tube();
  drape::DrapeStart refused = drape::prepare_start(narrow, {}).value();
  EXPECT_FALSE(drape::without_refused(narrow, refused, {}).has_value()) << "too little would remain";
  EXPECT_TRUE(preflight::first_error(refused.findings));
}

TEST(FitStart, WhatSlipsDownIsNotWorn) {
  pattern::Pattern wide = test::strapless();
  wide.panels = {
      test::polygon("bodice_front", {{-400, 0}, {400, 0}, {400, 300}, {-400, 300}}),
      test::polygon("bodice_back", {{-400, 0}, {400, 0}, {400, 300}, {-400, 300}}),
  };
  drape::DrapeInput input = test::heap_of(std::move(wide));
  input.settings.max_time = 2;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(r.worn, drape::Worn::kNo);
  EXPECT_TRUE(told(r.findings, preflight::FindingKind::kSlipped) ||
              told(r.findings, preflight::FindingKind::kOnGround));
}

}  // namespace
}  // namespace toile
