#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/body/mannequin/broyden.h"

namespace toile {
namespace {

/// Three numbers that move each other's values, and bend.
std::vector<double> off_at(const std::vector<double>& x) {
  return {1.3 * x[0] + 0.2 * x[1] - 1, 0.9 * x[1] + 0.3 * x[2] * x[2] - 0.5, x[2] - 0.25 * x[0] + 0.1};
}

double worst_of(const std::vector<double>& off) {
  double worst = 0;
  for (const double v : off) worst = std::max(worst, std::abs(v));
  return worst;
}

TEST(Broyden, BringsToNothingWhatSeveralNumbersMoveTogether) {
  mannequin::Broyden broyden;
  EXPECT_TRUE(broyden.empty());
  broyden.begin(3);
  std::vector<double> x(3, 0.0), off = off_at(x);
  for (int round = 0; round < 20 && worst_of(off) > 1e-10; ++round) {
    const std::vector<double> step = broyden.step(off, 1), before = off;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += step[i];
    off = off_at(x);
    broyden.learn(step, before, off);
  }
  EXPECT_LT(worst_of(off), 1e-6);
}

TEST(Broyden, TellsTheLastStepFromItsEffectOnceItHasLearntIt) {
  mannequin::Broyden broyden;
  broyden.begin(2);
  const std::vector<double> step{0.1, -0.05}, before{0.4, 0.2}, after{0.55, 0.1};
  broyden.learn(step, before, after);
  const std::vector<double> told = broyden.step({before[0] - after[0], before[1] - after[1]}, 1);
  EXPECT_NEAR(told[0], step[0], 1e-15);
  EXPECT_NEAR(told[1], step[1], 1e-15);
}

TEST(Broyden, LearnsNothingFromAStepWithoutEffect) {
  mannequin::Broyden broyden;
  broyden.begin(2);
  broyden.learn({0.1, 0.1}, {0.4, 0.2}, {0.4, 0.2});
  EXPECT_EQ(broyden.step({0.4, 0.2}, 0.5), (std::vector<double>{-0.2, -0.1}));
}

}  // namespace
}  // namespace toile
