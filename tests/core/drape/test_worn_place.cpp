// Whether a garment whose rings go around the right limbs lies where it belongs.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/drape/drape_start.h"
#include "core/drape/worn_place.h"
#include "core/drape/worn_verdict.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/drape/heap.h"
#include "tests/core/drape/runs.h"

namespace toile {
namespace {

/// A garment on the mannequin, `moved` as a whole.
struct OnBody {
  drape::DrapeInput input;
  drape::DrapeStart start;
  std::vector<Vec3> x;

  explicit OnBody(pattern::Pattern pattern, Vec3 moved = {})
      : input(test::heap_of(std::move(pattern))), start(drape::prepare_start(input, {}).value()) {
    drape::dress_start(input, start, {});
    x = start.dressed.value().positions;
    for (Vec3& p : x) p += moved;
  }

  drape::WornVerdict judged(const dressing::Person& person, double higher = 0) const {
    std::vector<double> tops = drape::tops_of(start.placed.garment, x);
    for (double& top : tops) top += higher;
    return drape::judge_worn(input, person, start.placed.garment, x, tops, {});
  }
};

TEST(WornPlace, AShirtThatIsOnIsWorn) {
  const drape::WornVerdict verdict = OnBody(test::shirt()).judged(test::person());
  EXPECT_EQ(verdict.worn, drape::Worn::kYes);
  EXPECT_TRUE(verdict.findings.empty());
}

TEST(WornPlace, AShirtThatLiesBelowBothShouldersHasSlidOffThem) {
  const OnBody shirt(test::shirt());
  dressing::Person wearer = test::person();
  for (Vec3& shoulder : wearer.figure.shoulder) shoulder.y += 0.15;
  for (Vec3& neck : wearer.figure.neck_side) neck.y += 0.15;
  const drape::WornVerdict fell = shirt.judged(wearer, 0.15);
  EXPECT_EQ(fell.worn, drape::Worn::kNo);
  EXPECT_EQ(std::count_if(
                fell.findings.begin(), fell.findings.end(),
                [](const preflight::Finding& f) { return f.kind == preflight::FindingKind::kOffShoulder; }),
            2);
}

TEST(WornPlace, AHoodThatFellBackIsNoGarmentThatSlipped) {
  OnBody shirt(test::shirt());
  shirt.input.pattern.panels[0].id = "hood";
  std::vector<double> tops = drape::tops_of(shirt.start.placed.garment, shirt.x);
  const auto slipped = [&] {
    return told(drape::judge_worn(shirt.input, test::person(), shirt.start.placed.garment, shirt.x, tops, {})
                    .findings,
                preflight::FindingKind::kSlipped);
  };
  tops[0] += 0.55;  // it was that much higher than it is, before it lay on the head
  EXPECT_FALSE(slipped());
  shirt.input.pattern.panels[0].id = "front";
  EXPECT_TRUE(slipped()) << "but a front came down by all of the chest, though the rest did not";
  shirt.input.pattern.panels[0].id = "hood";
  for (std::size_t p = 1; p < tops.size(); ++p) tops[p] += 0.35;
  EXPECT_TRUE(slipped());
}

TEST(WornPlace, ASkirtThatLiesAtTheWaistHasNotSlippedThoughItWasPutOnHigher) {
  OnBody skirt(test::skirt());
  const auto name = [&](const std::string& kind) {
    for (std::size_t p = 0; p < skirt.input.pattern.panels.size(); ++p)
      skirt.input.pattern.panels[p].id = kind + (p == 0 ? "_front" : "_back");
  };
  name("skirt");
  const std::vector<double> tops = drape::tops_of(skirt.start.placed.garment, skirt.x);
  const double waist = test::person().figure.waist;
  const auto slipped = [&](double below_waist) {
    const double down = *std::max_element(tops.begin(), tops.end()) - (waist - below_waist);
    std::vector<Vec3> x = skirt.x;
    for (Vec3& p : x) p.y -= down;
    std::vector<double> higher(tops.size(), waist + 0.25);
    return told(
        drape::judge_worn(skirt.input, test::person(), skirt.start.placed.garment, x, higher, {}).findings,
        preflight::FindingKind::kSlipped);
  };
  EXPECT_FALSE(slipped(0));
  EXPECT_TRUE(slipped(0.1)) << "on the hips";
  name("bodice");
  EXPECT_TRUE(slipped(0)) << "a bodice hangs higher";
}

/// It began below them, as a dress does that leaves the shoulders bare.
TEST(WornPlace, WhatNeverLayOnAShoulderHasNotSlidOffIt) {
  const OnBody shirt(test::shirt());
  dressing::Person wearer = test::person();
  for (Vec3& shoulder : wearer.figure.shoulder) shoulder.y += 0.15;
  EXPECT_FALSE(told(shirt.judged(wearer).findings, preflight::FindingKind::kOffShoulder));
}

TEST(WornPlace, ABodiceAroundTheHipsIsNotWorn) {
  EXPECT_EQ(OnBody(test::strapless()).judged(test::person()).worn, drape::Worn::kYes);
  const OnBody low(test::strapless(), {0, -0.4, 0});
  const drape::WornVerdict verdict = low.judged(test::person());
  EXPECT_FALSE(told(verdict.findings, preflight::FindingKind::kRingOff));
  EXPECT_TRUE(told(verdict.findings, preflight::FindingKind::kElsewhere));
  EXPECT_EQ(verdict.worn, drape::Worn::kNo);
}

TEST(WornPlace, ASleeveAroundTheHipsIsNotWorn) {
  OnBody skirt(test::skirt());
  EXPECT_EQ(skirt.judged(test::person()).worn, drape::Worn::kYes);
  skirt.input.pattern.panels[0].id = "left_sleeve";
  EXPECT_TRUE(told(skirt.judged(test::person()).findings, preflight::FindingKind::kElsewhere));
}

/// The cloth that lay nearer to the neck hangs down; only what lies over the arms' roots is as high as
/// before.
TEST(WornPlace, StrapsOverTheArmsRootsHaveSlidOffTheShoulders) {
  OnBody top(test::shirt());
  const std::vector<double> tops = drape::tops_of(top.start.placed.garment, top.x);
  const measure::BodyFigure& figure = test::person().figure;
  std::vector<dressing::WornRing> rings(2);
  rings[0].around.times[dressing::kLeftArm] = rings[1].around.times[dressing::kRightArm] = 1;
  for (dressing::WornRing& ring : rings) ring.vertices = {0};
  const auto slid = [&](double reach) {
    std::vector<Vec3> x = top.x;
    for (Vec3& p : x)
      for (const std::size_t side : {measure::kWearersLeft, measure::kWearersRight})
        if (std::abs(p.x - figure.middle) < reach * std::abs(figure.shoulder[side].x - figure.middle) &&
            p.y > figure.shoulder[side].y - 0.1)
          p.y -= 0.2;
    return std::ssize(drape::out_of_place(top.input, figure, top.start.placed.garment, x, tops, rings));
  };
  EXPECT_EQ(slid(0), 0);
  EXPECT_EQ(slid(0.7), 0) << "a wide neckline leaves straps on the shoulders";
  EXPECT_EQ(slid(0.95), 2);
}

/// What is found when the garment's borders go around these limbs, each with its girth (m).
preflight::Findings found_with(const OnBody& shirt,
                               const std::vector<std::pair<std::vector<dressing::Limb>, double>>& borders) {
  std::vector<dressing::WornRing> rings;
  for (const auto& [limbs, girth] : borders) {
    dressing::WornRing& ring = rings.emplace_back();
    ring.girth = girth;
    ring.right = true;
    for (const dressing::Limb limb : limbs) ring.around.times[limb] = 1;
    const auto low =
        std::min_element(shirt.x.begin(), shirt.x.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; });
    ring.vertices = {static_cast<Index>(low - shirt.x.begin())};
  }
  return drape::out_of_place(shirt.input, test::person().figure, shirt.start.placed.garment, shirt.x,
                             drape::tops_of(shirt.start.placed.garment, shirt.x), rings);
}

TEST(WornPlace, AHeadThatGoesThroughAnArmholeHasNoNeck) {
  using enum dressing::Limb;
  const OnBody shirt(test::shirt());
  const auto neck_shut = [&](const std::vector<std::pair<std::vector<dressing::Limb>, double>>& borders) {
    return told(found_with(shirt, borders), preflight::FindingKind::kNeckShut);
  };
  EXPECT_TRUE(neck_shut({{{kHead, kRightArm}, 0.47}, {{kLeftArm}, 0.46}, {{kLeftLeg, kRightLeg}, 1.1}}));
  EXPECT_TRUE(neck_shut({{{kHead, kLeftArm}, 0.46}, {{kRightArm}, 0.46}, {{kLeftLeg, kRightLeg}, 1.1}}));
  EXPECT_FALSE(neck_shut({{{kHead, kRightArm}, 0.8}, {{kLeftArm}, 0.46}, {{kLeftLeg, kRightLeg}, 1.1}}))
      << "one shoulder is bare";
  EXPECT_FALSE(
      neck_shut({{{kHead}, 0.5}, {{kRightArm}, 0.46}, {{kLeftArm}, 0.46}, {{kLeftLeg, kRightLeg}, 1}}));
}

TEST(WornPlace, ArmsInAGarmentThatHasNeitherHeadNorLegsAreNoWayToWearIt) {
  using enum dressing::Limb;
  const OnBody shirt(test::shirt());
  const auto apron = found_with(shirt, {{{kLeftArm, kRightArm}, 1.1}, {{kLeftArm}, 0.4}, {{kRightArm}, 0.4}});
  EXPECT_TRUE(told(apron, preflight::FindingKind::kNeckShut));
  // The border of an open jacket runs on along the neck.
  const OnBody jacket(test::shirt(), {0, 1, 0});
  const auto open = found_with(jacket, {{{kLeftArm, kRightArm}, 2.6}, {{kLeftArm}, 0.4}, {{kRightArm}, 0.4}});
  EXPECT_FALSE(told(open, preflight::FindingKind::kNeckShut));
}

}  // namespace
}  // namespace toile
