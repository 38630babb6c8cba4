// A garment without the pieces that nothing holds on.

#include "core/drape/worn_part.h"

#include <gtest/gtest.h>

#include "core/drape/pipeline.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/drape/heap.h"

namespace toile {
namespace {

void add_piece(drape::DrapeInput& input, const std::string& id) {
  input.pattern.panels.push_back(test::polygon(id, {{0, 0}, {80, 0}, {80, 60}, {0, 60}}));
  input.fabric_of_panel.push_back(0);
  input.placements.emplace_back(sewing::RigidPlacement{{1, 1, 0}, {}, {}});
}

TEST(WornPart, IsAllOfWhatIsSewn) {
  const drape::DrapeInput input = test::heap_of(test::shirt());
  EXPECT_TRUE(drape::worn_part(input).left_out.empty());
  EXPECT_EQ(drape::worn_part(input).pattern.panels.size(), input.pattern.panels.size());
}

TEST(WornPart, LeavesOutAPocketThatNobodySewsOn) {
  drape::DrapeInput input = test::heap_of(test::shirt());
  const std::size_t pieces = input.pattern.panels.size(), seams = input.pattern.seams.size();
  add_piece(input, "pocket");
  // The pocket goes first, so that every number changes.
  std::rotate(input.pattern.panels.begin(), input.pattern.panels.end() - 1, input.pattern.panels.end());
  std::rotate(input.placements.begin(), input.placements.end() - 1, input.placements.end());
  for (pattern::Seam& seam : input.pattern.seams)
    for (auto* side : {&seam.a, &seam.b})
      for (pattern::SeamEdge& e : *side) ++e.panel;
  const drape::DrapeInput worn = drape::worn_part(input);
  EXPECT_EQ(worn.pattern.panels.size(), pieces);
  ASSERT_EQ(worn.left_out.size(), 1U);
  EXPECT_EQ(worn.left_out[0].id, "pocket");
  EXPECT_TRUE(worn.left_out[0].layer);
  EXPECT_NEAR(worn.left_out[0].place.x, 1.04, 1e-3);
  ASSERT_EQ(worn.pattern.seams.size(), seams);
  const pattern::Pattern shirt = test::shirt();
  for (std::size_t s = 0; s < seams; ++s)
    EXPECT_EQ(worn.pattern.seams[s].a.front().panel, shirt.seams[s].a.front().panel);
}

TEST(WornPart, LeavesOutAPocketThatIsSewnToItself) {
  drape::DrapeInput input = test::heap_of(test::shirt());
  add_piece(input, "patch");
  const auto patch = static_cast<Index>(input.pattern.panels.size()) - 1;
  input.pattern.seams.push_back({"its_sides", {{patch, 1}}, {{patch, 3}}});
  const drape::DrapeInput worn = drape::worn_part(input);
  ASSERT_EQ(worn.left_out.size(), 1U);
  EXPECT_EQ(worn.left_out[0].id, "patch");
}

TEST(WornPart, KeepsWhatIsHeldOtherwise) {
  drape::DrapeInput input = test::heap_of(test::shirt());
  add_piece(input, "scarf");
  sewing::Attachment hold;
  hold.panel = static_cast<Index>(input.pattern.panels.size()) - 1;
  input.attachments.push_back(hold);
  EXPECT_TRUE(drape::worn_part(input).left_out.empty());
}

TEST(WornPart, KeepsASecondGarment) {
  pattern::Pattern both = test::shirt();
  const auto above = static_cast<Index>(both.panels.size());
  const pattern::Pattern skirt = test::skirt();
  both.panels.insert(both.panels.end(), skirt.panels.begin(), skirt.panels.end());
  for (pattern::Seam seam : skirt.seams) {
    seam.id += "_skirt";
    for (auto* side : {&seam.a, &seam.b})
      for (pattern::SeamEdge& e : *side) e.panel += above;
    both.seams.push_back(seam);
  }
  EXPECT_TRUE(drape::worn_part(test::heap_of(both)).left_out.empty());
}

TEST(WornPart, ABeltIsKnottedAndNotMissing) {
  drape::DrapeInput input = test::heap_of(test::shirt());
  add_piece(input, "Belt");
  const drape::DrapeInput worn = drape::worn_part(input);
  ASSERT_EQ(worn.left_out.size(), 1U);
  EXPECT_TRUE(worn.left_out[0].tied);
  preflight::Findings findings;
  drape::tell_left_out(worn, findings);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, preflight::Severity::kNote);
  EXPECT_NE(findings[0].message.find("knotted"), std::string::npos) << findings[0].message;
}

/// A shirt whose sleeves are sewn to themselves alone.
pattern::Pattern without_caps() {
  pattern::Pattern shirt = test::shirt();
  const auto on_sleeve = [&](const pattern::SeamEdge& e) {
    return shirt.panels[e.panel].id.find("sleeve") != std::string::npos;
  };
  std::erase_if(shirt.seams,
                [&](const pattern::Seam& s) { return on_sleeve(s.a.front()) != on_sleeve(s.b.front()); });
  return shirt;
}

TEST(WornPart, LeavesOutASleeveWithoutItsArmhole) {
  const drape::DrapeInput worn = drape::worn_part(test::heap_of(without_caps()));
  ASSERT_EQ(worn.left_out.size(), 2U);
  for (const drape::LeftOut& piece : worn.left_out) EXPECT_FALSE(piece.layer) << piece.id;
}

TEST(WornPart, ABodiceWithoutItsSleevesIsPutOnAsATop) {
  const drape::DrapeInput worn = drape::worn_part(test::heap_of(without_caps()));
  ASSERT_EQ(worn.pattern.panels.size(), 2U);
  drape::DrapeStart start = drape::prepare_start(worn, {}).value();
  drape::dress_start(worn, start, {});
  EXPECT_TRUE(start.dressed.has_value());
}

TEST(WornPart, IsAllWhereNobodyIsDressed) {
  drape::DrapeInput input = test::heap_of(test::shirt());
  add_piece(input, "pocket");
  drape::DrapeInput alone = input;
  alone.bodies.clear();
  EXPECT_TRUE(drape::worn_part(alone).left_out.empty());
  input.settings.dress = false;
  EXPECT_TRUE(drape::worn_part(input).left_out.empty());
}

TEST(WornPart, WhatWasLeftOutIsTold) {
  drape::DrapeInput input = test::heap_of(test::shirt());
  add_piece(input, "pocket");
  add_piece(input, "strap");
  const drape::DrapeStart start = drape::prepare_start(drape::worn_part(input), {}).value();
  std::vector<std::string> told;
  for (const preflight::Finding& f : start.findings)
    if (f.kind == preflight::FindingKind::kLeftOut) told.push_back(f.about.front().id);
  EXPECT_EQ(told, (std::vector<std::string>{"strap", "pocket"})) << "the strap is missed, the pocket is not";
}

TEST(WornPart, ASmallTrimOfWhichNothingTellsIsNotMissing) {
  drape::DrapeInput input = test::heap_of(test::shirt());
  input.pattern.panels.push_back(test::polygon("Zwirbel", {{0, 0}, {60, 0}, {60, 20}, {0, 20}}));
  input.fabric_of_panel.push_back(0);
  input.placements.emplace_back(sewing::RigidPlacement{{1, 1, 0}, {}, {}});
  ASSERT_EQ(drape::worn_part(input).left_out.size(), 1U);
  EXPECT_TRUE(drape::worn_part(input).left_out[0].layer);
  input.pattern.panels.back() = test::polygon("Zwirbel", {{0, 0}, {300, 0}, {300, 100}, {0, 100}});
  EXPECT_FALSE(drape::worn_part(input).left_out[0].layer) << "as large as a collar";
}

}  // namespace
}  // namespace toile
