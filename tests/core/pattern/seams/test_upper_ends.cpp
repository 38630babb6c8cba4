// Which end of a piece is up, whichever way its grain line is drawn and however it is laid out.

#include "core/pattern/seams/upper_ends.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "tests/core/pattern/garments.h"
#include "tests/core/pattern/seams/worn_seams.h"

namespace toile {
namespace {

using garments::piece;
using garments::plain_top;
using garments::turned;
using Panels = std::vector<pattern::Panel>;

constexpr double kQuarter = std::numbers::pi / 2;

Panels leg_halves() {
  Panels panels = garments::trousers().panels;
  for (pattern::Panel& panel : panels) panel.id = panel.id.starts_with("front") ? "front" : "back";
  panels[2].id += "_mirrored";
  panels[3].id += "_mirrored";
  return panels;
}

pattern::Panel gore(const std::string& name) {
  return piece(name, {{0, 0}, {300, 0}, {220, 600}, {80, 600}});
}

Panels hoods() {
  const pattern::Panel half = piece(
      "hood", {{0, 0}, {210, 0, Vec2{330, 160}, Vec2{250, 330}}, {20, 330, Vec2{90, 220}, Vec2{70, 90}}});
  return {half, garments::mirrored(half, "hood_mirrored")};
}

/// Short, with an end between the openings for the legs.
Panels briefs() {
  Panels panels;
  for (const char* name : {"front", "back"})
    panels.push_back(piece(name, {{-40, 0},
                                  {40, 0, Vec2{60, 120}},
                                  {230, 180},
                                  {220, 260},
                                  {-220, 260},
                                  {-230, 180, Vec2{-60, 120}}}));
  return panels;
}

/// The garment laid out by quarter turns, with grain lines that point where `sense` says.
Panels laid(const Panels& panels, int quarters, int sense) {
  Panels out;
  for (const pattern::Panel& panel : panels) {
    out.push_back(turned(panel, quarters * kQuarter));
    out.back().grain = out.back().grain * sense;
  }
  return out;
}

void expect_up(const Panels& panels, int quarters, int sense, const char* what) {
  const Panels layout = laid(panels, quarters, sense);
  const std::vector<Vec2> up = seams::grains_upwards(layout);
  ASSERT_EQ(up.size(), panels.size());
  for (std::size_t p = 0; p < up.size(); ++p)
    EXPECT_GT(dot(up[p], layout[p].grain * sense), 0.99)
        << what << ": " << panels[p].id << ", " << quarters << " quarters, " << sense;
}

TEST(UpperEnds, AreToldByShapesHoweverPiecesAreLaidOut) {
  const Panels top{plain_top("front", 520), plain_top("back", 600)};
  const Panels skirt{gore("skirt_front"), gore("skirt_back")};
  for (int quarters = 0; quarters < 4; ++quarters)
    for (const int sense : {1, -1}) {
      expect_up(top, quarters, sense, "top");
      expect_up(leg_halves(), quarters, sense, "trousers");
      expect_up(skirt, quarters, sense, "skirt");
      expect_up(hoods(), quarters, sense, "hood");
    }
}

/// Nothing of a robe's front is hollow, and it may lie otherwise than its back.
TEST(UpperEnds, BodicesWithoutHollowsWidenToTheirHems) {
  const pattern::Panel front = piece("front", {{0, 0}, {380, 0}, {380, 1000}, {160, 1000}, {0, 380}});
  for (const int sense : {1, -1}) {
    const Panels layout{plain_top("back", 600), laid({front}, 1, sense)[0]};
    EXPECT_GT(dot(seams::grains_upwards(layout)[1], layout[1].grain * sense), 0.99) << sense;
  }
}

TEST(UpperEnds, WhatTellsNothingGoesWithThoseDrawnAlikeIfTheyAgree) {
  const Panels top{plain_top("front", 520), plain_top("back", 600), garments::strip("pocket", 120, 150)};
  expect_up(top, 2, -1, "all head first");
  Panels mixed = laid(top, 0, -1);
  mixed[0] = laid(top, 2, 1)[0];
  EXPECT_EQ(seams::grains_upwards(mixed)[2], mixed[2].grain) << "front and back disagree";
  Panels against = laid(top, 0, -1);
  against[2].grain = {0, 1};
  EXPECT_EQ(seams::grains_upwards(against)[2], (Vec2{0, 1})) << "it is drawn up, and so are they";
  Panels across = laid(top, 0, -1);
  across[2].grain = {1, 0};
  EXPECT_EQ(seams::grains_upwards(across)[2], (Vec2{1, 0})) << "none is drawn alike";
}

/// Their legs' openings are hollow, and face down.
TEST(UpperEnds, BriefsAreNotStoodOnTheirHeads) { expect_up(briefs(), 0, 1, "briefs"); }

TEST(UpperEnds, AHollowNeckTellsAlthoughTheHemLiesBetweenHollowsAsAForkDoes) {
  // The middle of a dress with princess seams that narrow towards the waist.
  const pattern::Panel middle = piece("front", {{-140, 0},
                                                {140, 0, Vec2{80, 330}, Vec2{60, 560}},
                                                {150, 880, Vec2{140, 920}, Vec2{135, 960}},
                                                {145, 1000},
                                                {90, 1045, Vec2{60, 950}, Vec2{-60, 950}},
                                                {-90, 1045},
                                                {-145, 1000, Vec2{-135, 960}, Vec2{-140, 920}},
                                                {-150, 880, Vec2{-60, 560}, Vec2{-80, 330}}});
  for (const int sense : {1, -1}) expect_up({middle}, 1, sense, "middle of a dress");
}

TEST(UpperEnds, AShallowNeckTellsWhereSleevesAreCutOnAndTheHemIsStraight) {
  pattern::Panel back = piece("back", {{-280, 0},
                                       {280, 0, Vec2{270, 190}},
                                       {400, 230},
                                       {460, 390},
                                       {115, 470, Vec2{0, 415}},
                                       {-115, 470},
                                       {-460, 390},
                                       {-400, 230, Vec2{-270, 190}}});
  back.grain = {0, -1};
  EXPECT_GT(seams::grains_upwards({back})[0].y, 0.99);
}

}  // namespace
}  // namespace toile
