// What a search is told of garments that differ in a few seams is what each would be worth if it came alone.

#include "core/pattern/seams/judge.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/pattern/seams/cuts.h"
#include "core/pattern/seams/moves.h"
#include "tests/core/pattern/garments.h"

namespace toile {
namespace {

using seams::SeamGluing;
using seams::SeamModel;

/// Changes what is sewn at random, but for `locked` runs, and judges each garment after the one before it.
void expect_alike(const SeamModel& model, SeamGluing gluing, const std::vector<char>& locked) {
  constexpr int kChanges = 600;
  const seams::Choices choices = seams::choices_of(model, locked);
  ASSERT_FALSE(choices.open.empty());
  const seams::GluingSettings settings;
  seams::GluingJudge judge(model, settings);
  seams::Numbers numbers(5);
  int changed = 0;
  for (int k = 0; k < kChanges; ++k) {
    SeamGluing next = gluing;
    if (!seams::change(choices, {}, numbers, next)) continue;
    ++changed;
    ASSERT_EQ(judge.merit(next), seams::gluing_merit(model, next, settings)) << "change " << k;
    if (numbers.below(2) == 0) gluing = std::move(next);  // the others are judged and left
  }
  EXPECT_GT(changed, kChanges / 4);
}

std::vector<char> none_of(const SeamModel& model) { return std::vector<char>(model.runs.size(), 0); }

TEST(GluingJudge, WhatAGarmentIsWorthDoesNotDependOnTheOneBefore) {
  for (const garments::Garment& garment : garments::all()) {
    const pattern::Pattern pattern{garment.panels, {}};
    SCOPED_TRACE(pattern.panels.front().id);
    const SeamModel whole = seams::make_seam_model(pattern);
    expect_alike(whole, seams::nothing_sewn(whole), none_of(whole));
    const SeamModel cut = seams::with_likely_cuts(pattern, whole, seams::CutKind::kFirstFirst);
    expect_alike(cut, seams::nothing_sewn(cut), none_of(cut));
  }
}

TEST(GluingJudge, NeitherInAWholeWardrobe) {
  pattern::Pattern wardrobe;
  for (int copy = 0; copy < 4; ++copy)
    for (const garments::Garment& garment : garments::all())
      for (pattern::Panel panel : garment.panels) {
        panel.id += "_" + std::to_string(copy);
        wardrobe.panels.push_back(std::move(panel));
      }
  ASSERT_GT(wardrobe.panels.size(), 64U);
  const SeamModel model = seams::make_seam_model(wardrobe);
  expect_alike(model, seams::nothing_sewn(model), none_of(model));
}

TEST(GluingJudge, AnEdgeMayBeInSeveralSeamsAlready) {
  const SeamModel model = seams::make_seam_model({garments::shirt().panels, {}});
  for (const auto& [first, second, shared] : {std::array<Index, 3>{1, 9, 12}, {1, 12, 5}, {12, 9, 4}}) {
    SeamGluing gluing = seams::nothing_sewn(model);
    std::vector<char> locked = none_of(model);
    for (const Index run : {first, second}) gluing.sew(run, shared, seams::pair_merit(model, run, shared));
    for (const Index run : {first, second, shared}) locked[run] = 1;
    expect_alike(model, gluing, locked);
  }
}

TEST(SewnPanels, HangTogetherUntilTheirLastSeamIsGone) {
  seams::SewnPanels panels(70);
  EXPECT_EQ(panels.parts(), 70);
  panels.add(0, 69);
  panels.add(69, 0);
  panels.add(69, 65);
  EXPECT_EQ(panels.parts(), 68);
  panels.remove(0, 69);
  EXPECT_EQ(panels.parts(), 68);
  panels.remove(69, 0);
  EXPECT_EQ(panels.parts(), 69);
}

}  // namespace
}  // namespace toile
