#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/pattern/curve.h"
#include "core/pattern/seams/garment_words.h"
#include "core/pattern/validate.h"
#include "core/project/create/fold_lines.h"
#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using Lines = std::vector<std::vector<Vec2>>;

pattern::Panel with_lines(pattern::Panel panel, const Lines& lines) {
  for (const std::vector<Vec2>& points : lines)
    panel.lines.push_back({"i" + std::to_string(panel.lines.size()), points, true});
  return panel;
}

std::optional<create::FoldLine> fold_of(const pattern::Panel& panel) {
  return create::fold_line(panel, seams::words_of(panel.id));
}

/// A front with a facing 60 mm broad right of x = 190, whose end above goes on to `top`: at 536 it is the
/// neck mirrored.
pattern::Panel front_with_facing(const std::string& name, double top) {
  return garments::piece(name, {{0, 0}, {250, 0}, {250, top}, {190, 500}, {90, 560}, {0, 540}});
}

TEST(FoldLines, AWaistbandIsFoldedAlongItsMiddle) {
  const pattern::Panel band =
      with_lines(garments::strip("Waistband", 776, 80), {{{0, 40}, {400, 40}, {776, 40}}});
  const auto fold = fold_of(band);
  ASSERT_TRUE(fold);
  EXPECT_TRUE(fold->halves);
  const pattern::Panel rest = create::folded(band, *fold);
  ASSERT_TRUE(pattern::validate(rest));
  EXPECT_NEAR(std::abs(pattern::signed_area(rest.outline)), 776 * 40, 1);
  ASSERT_EQ(rest.outline.edges.size(), 4u);
  EXPECT_EQ(rest.outline.edges[3].id, pattern::kFoldEdge);
  EXPECT_NEAR(garments::length_of(rest, 3), 776, 0.1);
  EXPECT_NEAR(garments::length_of(rest, 1), 776, 0.1) << "the edge that is sewn on";
  EXPECT_TRUE(rest.lines.empty()) << "what was folded is an edge";
}

TEST(FoldLines, TheHalfWithTheNotchesStays) {
  for (const double at : {0.0, 80.0}) {
    pattern::Panel band = with_lines(garments::strip("Waistband", 776, 80), {{{0, 40}, {776, 40}}});
    band.notches = {{{200, at}, 0, {}}, {{500, at}, 0, {}}};
    const auto fold = fold_of(band);
    ASSERT_TRUE(fold);
    const pattern::Panel rest = create::folded(band, *fold);
    EXPECT_EQ(rest.notches.size(), 2u);
    double nearest = HUGE_VAL;
    for (const Vec2 p : pattern::flatten(rest.outline, 1)) nearest = std::min(nearest, std::abs(p.y - at));
    EXPECT_NEAR(nearest, 0, 0.01);
  }
}

TEST(FoldLines, TheLineMayGoOnIntoTheAllowanceOrEndJustBefore) {
  const auto folds = [](const std::vector<Vec2>& line) {
    return fold_of(with_lines(garments::strip("Cuff", 240, 120), {line})).has_value();
  };
  EXPECT_TRUE(folds({{-10, 60}, {250, 60}}));
  EXPECT_TRUE(folds({{2, 60}, {238, 60}}));
  EXPECT_TRUE(folds({{14, 60}, {226, 60}})) << "in the middle of a strip";
  EXPECT_FALSE(folds({{20, 60}, {220, 60}})) << "a line of stitches";
  EXPECT_FALSE(folds({{0, 50}, {240, 50}})) << "not its middle";
  EXPECT_FALSE(folds({{120, 0}, {120, 120}})) << "across";
}

TEST(FoldLines, PiecesThatAreTheirOwnImageAreNoStrips) {
  const Lines middle{{{0, 45}, {400, 45}}};
  EXPECT_FALSE(fold_of(with_lines(garments::strip("Left sleeve", 400, 90), middle)));
  EXPECT_FALSE(fold_of(with_lines(garments::strip("Back bodice", 400, 90), middle)));
  EXPECT_FALSE(fold_of(with_lines(garments::strip("Strap", 400, 90), middle))) << "is sewn on by its ends";
  EXPECT_TRUE(fold_of(with_lines(garments::strip("47-11", 400, 90), middle))) << "whatever it is called";
  EXPECT_FALSE(fold_of(with_lines(garments::strip("47-11", 600, 260), {{{0, 130}, {600, 130}}}))) << "wide";
}

TEST(FoldLines, AFacingCutOnIsFoldedBackAndItsLineMayBeSewn) {
  const Lines lines{{{190, 0}, {190, 500}}, {{175, 0}, {175, 509}}};  // and the middle of the front
  const pattern::Panel front = with_lines(front_with_facing("Front bodice", 536), lines);
  const auto fold = fold_of(front);
  ASSERT_TRUE(fold);
  EXPECT_FALSE(fold->halves);
  EXPECT_NEAR(fold->from.x, 190, 0.01);
  const pattern::Panel rest = create::folded(front, *fold);
  ASSERT_TRUE(pattern::validate(rest));
  EXPECT_EQ(rest.lines.size(), 1u) << "the middle";
  ASSERT_EQ(rest.outline.edges.size(), 5u);
  EXPECT_EQ(rest.outline.edges[4].id, "e4");
  EXPECT_NEAR(garments::length_of(rest, 4), 500, 0.1);
}

TEST(FoldLines, PleatsAreNoFacing) {
  const Lines pleats{{{35, 0}, {35, 730}}, {{120, 0}, {120, 730}}, {{205, 0}, {205, 730}}};
  EXPECT_FALSE(fold_of(with_lines(garments::strip("Skirt front", 792, 730), pleats)));
}

TEST(FoldLines, ALineMayBeginAtACornerOfTheOutline) {
  // The neck is level in the facing, so that a corner lies where it is folded.
  const pattern::Panel front =
      with_lines(garments::piece("Front bodice",
                                 {{0, 0}, {250, 0}, {250, 500}, {190, 500}, {130, 500}, {60, 560}, {0, 540}}),
                 {{{190, 500}, {190, 0}}});
  EXPECT_TRUE(fold_of(front));
}

TEST(FoldLines, WhatDoesNotEndWhereTheFrontDoesIsNoFacing) {
  const Lines line{{{190, 0}, {190, 500}}};
  EXPECT_FALSE(fold_of(with_lines(front_with_facing("Front bodice", 500), line)))
      << "a corner that looks out below it";
  EXPECT_FALSE(fold_of(with_lines(front_with_facing("Back bodice", 536), line))) << "a back opens seldom";
  EXPECT_FALSE(fold_of(with_lines(front_with_facing("Front bodice", 536), {{{230, 0}, {230, 527}}})))
      << "20 mm that lap over";
}

}  // namespace
}  // namespace toile
