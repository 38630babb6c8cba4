#include "core/solver/constraints/stitch.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

constexpr double kStitchStep = 1e-3;  // s

/// Where three seams meet: a heavy vertex near the middle, light ones around it.
const std::vector<Vec3> kApart{{0, 0, 0}, {0.1, 0, 0}, {0, 0.02, 0}, {0, 0, -0.3}};
const std::vector<double> kInverseMass{1e3, 1e5, 4e4, 2e5};
const std::vector<solver::constraints::Stitch> kMeeting{
    {0, 1, 0.1, 0.5}, {0, 2, 0.02, 0.5}, {2, 3, 0.3, 0.5}};

Vec3 momentum(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  Vec3 sum;
  for (std::size_t v = 0; v < from.size(); ++v) sum += (to[v] - from[v]) * (1 / kInverseMass[v]);
  return sum;
}

TEST(Stitch, AGroupThatClosesDoesNotPushTheGarmentAway) {
  const auto groups = solver::constraints::stitch_groups(kMeeting, 4);
  ASSERT_EQ(groups.size(), 1u);
  std::vector<Vec3> x = kApart;
  solver::constraints::close_groups(groups, kInverseMass, kStitchStep, x);
  EXPECT_NE(x, kApart);
  EXPECT_NEAR(length(momentum(kApart, x)), 0, 1e-12);
}

TEST(Stitch, NoVertexOfAGroupIsPulledHarderThanAThreadMay) {
  std::vector<Vec3> x = kApart;
  solver::constraints::close_groups(solver::constraints::stitch_groups(kMeeting, 4), kInverseMass,
                                    kStitchStep, x);
  for (std::size_t v = 0; v < x.size(); ++v) {
    EXPECT_LE(length(x[v] - kApart[v]) / kInverseMass[v], 0.5 * kStitchStep * kStitchStep * (1 + 1e-9)) << v;
  }
}

TEST(Stitch, AGroupClosesAndComesToAVertexThatIsHeld) {
  std::vector<double> w = kInverseMass;
  w[2] = 0;
  std::vector<Vec3> x = kApart;
  for (int k = 0; k < 2000; ++k)
    solver::constraints::close_groups(solver::constraints::stitch_groups(kMeeting, 4), w, kStitchStep, x);
  for (const Vec3& p : x) EXPECT_LT(length(p - kApart[2]), 1e-5);
}

}  // namespace
}  // namespace toile
