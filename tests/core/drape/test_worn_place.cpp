// Whether a garment whose rings go around the right limbs lies where it belongs.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/drape/drape_start.h"
#include "core/drape/worn_verdict.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/drape/heap.h"

namespace toile {
namespace {

bool told(const preflight::Findings& findings, preflight::FindingKind kind) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const preflight::Finding& f) { return f.kind == kind; });
}

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
  const drape::WornVerdict fell = shirt.judged(wearer, 0.15);
  EXPECT_EQ(fell.worn, drape::Worn::kNo);
  EXPECT_EQ(std::count_if(
                fell.findings.begin(), fell.findings.end(),
                [](const preflight::Finding& f) { return f.kind == preflight::FindingKind::kOffShoulder; }),
            2);
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

}  // namespace
}  // namespace toile
