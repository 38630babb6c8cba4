#include "core/drape/rest_probe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toile {
namespace {

using Answer = drape::RestProbe::Answer;

constexpr double kProbeStep = 1e-3, kSpeed = 5e-3;
constexpr int kSide = 40;

/// A square of kSide by kSide vertices.
std::vector<std::array<Index, 3>> sheet() {
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i + 1 < kSide; ++i) {
    for (Index j = 0; j + 1 < kSide; ++j) {
      const Index v = i * kSide + j;
      triangles.push_back({v, v + 1, v + kSide});
      triangles.push_back({v + 1, v + kSide + 1, v + kSide});
    }
  }
  return triangles;
}

/// The answer to a sheet whose vertex v is moved(v, s) metres off after s seconds.
template <typename Motion>
Answer answer_to(drape::RestProbe& probe, Motion moved) {
  const auto triangles = sheet();
  std::vector<Vec3> x(kSide * kSide);
  probe.begin(x);
  Answer answer = Answer::kNotYet;
  for (int s = 1; s <= 1000 && answer == Answer::kNotYet; ++s) {
    for (std::size_t v = 0; v < x.size(); ++v) x[v].y = moved(static_cast<int>(v), s * kProbeStep);
    answer = probe.observe(x, triangles);
  }
  return answer;
}
template <typename Motion>
Answer answer_to(Motion moved) {
  drape::RestProbe probe(kProbeStep, kSpeed);
  return answer_to(probe, moved);
}

bool in_patch(int v) { return v / kSide >= 4 && v / kSide < 8 && v % kSide >= 4 && v % kSide < 8; }

TEST(RestProbe, WhatSwingsAboutItsBalanceByHalfAMillimetreStays) {
  EXPECT_EQ(answer_to([](int, double t) { return 0.2e-3 * (1 - std::cos(5 * t)); }), Answer::kStays);
}

TEST(RestProbe, WhatIsFarFromItsBalanceGoesHoweverSlowItIs) {
  EXPECT_EQ(answer_to([](int, double t) { return 5e-3 * (1 - std::cos(5 * t)); }), Answer::kGoes);
}

TEST(RestProbe, APatchThatTipsOverIsLookedAtAgain) {
  EXPECT_EQ(answer_to([](int v, double t) { return in_patch(v) ? 0.02e-3 * std::cosh(20 * t) : 0; }),
            Answer::kAgain);
}

TEST(RestProbe, ASingleVertexMayHop) {
  EXPECT_EQ(answer_to([](int v, double t) { return v == 60 ? 2e-3 * std::abs(std::sin(40 * t)) : 0; }),
            Answer::kStays);
}

TEST(RestProbe, WhatNeverStaysIsNotAskedForEver) {
  drape::RestProbe probe(kProbeStep, kSpeed);
  int asked = 0;
  for (; probe.asks() && asked < 100; ++asked) {
    EXPECT_NE(answer_to(probe, [](int v, double t) { return in_patch(v) ? t : 0; }), Answer::kStays);
  }
  EXPECT_GT(asked, 3);
  EXPECT_LT(asked, 100);
  EXPECT_FALSE(probe.on());
  probe.restart();
  EXPECT_TRUE(probe.asks());
}

}  // namespace
}  // namespace toile
