// Which cloth is around a limb.

#include <gtest/gtest.h>

#include "core/dressing/limbs.h"

namespace toile {
namespace {

/// Someone of 1.7 m with the arms held down and out.
measure::BodyFigure figure_of_mannequin() {
  measure::BodyFigure f;
  f.top = 1.7;
  f.crotch = 0.78;
  for (const int side : {0, 1}) {
    const double out = side == 0 ? 1 : -1;
    measure::ArmLine& arm = f.arm[side];
    arm.root = {out * 0.17, 1.38, 0};
    arm.elbow = {out * 0.32, 1.17, 0};
    arm.wrist = {out * 0.46, 0.98, 0};
    arm.tip = {out * 0.53, 0.85, 0};
  }
  return f;
}

TEST(Limbs, AreWhatHangsBelowTheCrotchOrAlongAnArm) {
  const measure::BodyFigure person = figure_of_mannequin();
  EXPECT_TRUE(dressing::is_around_limb(person, {0.1, 0.5, 0.05})) << "a knee";
  EXPECT_TRUE(dressing::is_around_limb(person, {0.44, 1.0, 0.05})) << "a left cuff";
  EXPECT_TRUE(dressing::is_around_limb(person, {-0.3, 1.25, -0.06})) << "a right sleeve";
  EXPECT_TRUE(dressing::is_around_limb(person, {0.5, 0.9, 0})) << "a hand";
}

TEST(Limbs, AreNotTheTrunkTheNeckOrWhatHangsAroundAll) {
  const measure::BodyFigure person = figure_of_mannequin();
  EXPECT_FALSE(dressing::is_around_limb(person, {0.13, 1.0, 0.1})) << "a waist";
  EXPECT_FALSE(dressing::is_around_limb(person, {0.18, 0.9, 0})) << "a hip";
  EXPECT_FALSE(dressing::is_around_limb(person, {0, 1.5, 0.05})) << "a neck";
  EXPECT_FALSE(dressing::is_around_limb(person, {0.17, 1.42, 0})) << "a shoulder's end";
  EXPECT_FALSE(dressing::is_around_limb(person, {0.7, 1.2, 0})) << "wide of the arm";
}

}  // namespace
}  // namespace toile
