// Equations 3 to 6 of Kim and Park 2003, each as its header reads it.

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/paper/bend.h"
#include "core/paper/integrate.h"
#include "core/paper/stretch.h"

namespace toile {
namespace {

TEST(Verlet, WhatFallsGoesHalfOfGTSquaredAndAStepMore) {
  // x_n = g·Δt²·n(n+1)/2 from a standstill: the exact way and half a step's worth.
  const double dt = 0.01;
  Vec3 x, previous;
  for (int n = 0; n < 100; ++n) {
    const Vec3 next = paper::next_place(x, previous, {0, -9.81, 0}, dt, 0);
    previous = x;
    x = next;
  }
  EXPECT_NEAR(x.y, -9.81 / 2 * (1 + dt), 1e-9);
}

TEST(Verlet, WithoutForceAndDampingAParticleKeepsItsWay) {
  EXPECT_EQ(paper::next_place({2, 0, 0}, {1, 0, 0}, {}, 0.01, 0), (Vec3{3, 0, 0}));
}

TEST(VerletDamping, IsTheShareOfItsWayThatAParticleLosesWithAStep) {
  EXPECT_NEAR(paper::next_place({2, 0, 0}, {1, 0, 0}, {}, 0.01, 0.25).x, 2.75, 1e-15);
}

TEST(VerletDamping, LetsWhatFallsReachASpeedAndNoMore) {
  const double dt = 0.01, d = 0.1;
  Vec3 x, previous;
  for (int n = 0; n < 1000; ++n) {
    const Vec3 next = paper::next_place(x, previous, {0, -9.81, 0}, dt, d);
    previous = x;
    x = next;
  }
  EXPECT_NEAR((previous.y - x.y), 9.81 * dt * dt / d, 1e-9) << "what damping takes is what gravity gives";
}

TEST(StrainLimit, DrawsWhatIsBeyondItBackToItsRestLength) {
  Vec3 a{0, 0, 0}, b{0, 1.3, 0};
  paper::pull_together(a, b, 1, 1, 1, 0.2);
  EXPECT_NEAR(length(b - a), 1, 1e-15);
  EXPECT_NEAR(a.y, 0.15, 1e-15) << "both come half of the way";
}

TEST(StrainLimit, LeavesTheCommonCentreOfMassWhereItIs) {
  const double m1 = 1, m2 = 3;
  Vec3 a{0, 0, 0}, b{0, 2, 0};
  const double before = m1 * a.y + m2 * b.y;
  paper::pull_together(a, b, 1 / m1, 1 / m2, 1, 0);
  EXPECT_NEAR(m1 * a.y + m2 * b.y, before, 1e-14) << "in print both would drift along the link";
  EXPECT_NEAR(a.y, 0.75, 1e-14) << "the lighter one goes farther";
}

TEST(StrainLimit, LeavesAloneWhatIsWithinItAndWhatIsPushedTogether) {
  for (const double l : {1.19, 1.0, 0.5, 0.0}) {
    Vec3 a, b{l, 0, 0};
    paper::pull_together(a, b, 1, 1, 1, 0.2);
    EXPECT_EQ(b, (Vec3{l, 0, 0})) << l;
    EXPECT_EQ(a, Vec3());
  }
}

TEST(ArcCosine, IsTheLibrarysToTwoInAHundredMillion) {
  for (int k = -1000; k <= 1000; ++k) EXPECT_NEAR(paper::arc_cosine(k / 1000.0), std::acos(k / 1000.0), 3e-8);
}

TEST(AngleBetween, OfTwoLinksIsTheirsAndOfALinkWithoutLengthNone) {
  EXPECT_NEAR(paper::angle_between({1, 1, 0}, {3, 1, 0}, {1, 1, 5}), kPi / 2, 1e-7);
  EXPECT_EQ(paper::angle_between({1, 1, 0}, {1, 1, 0}, {1, 1, 5}), 0);
}

TEST(BendingRecovery, OfAFlatFanIsNone) { EXPECT_EQ(paper::recovery(0), 0); }

TEST(BendingRecovery, GrowsAsTheSquareRootOfTheDeformationSoThatItsShareFalls) {
  EXPECT_NEAR(paper::recovery(0.04), 2 * paper::recovery(0.01), 1e-15);
  EXPECT_LT(paper::recovery(0.04) / 0.04, paper::recovery(0.01) / 0.01);
}

TEST(BendingRecovery, EndsAtTheWholeWay) {
  EXPECT_EQ(paper::recovery(5), 1);
  EXPECT_EQ(paper::recovered({2, 0, 0}, {1, 0, 0}, 1), (Vec3{1, 0, 0})) << "where it was before the step";
  EXPECT_EQ(paper::recovered({2, 0, 0}, {1, 0, 0}, 0), (Vec3{2, 0, 0}));
}

}  // namespace
}  // namespace toile
