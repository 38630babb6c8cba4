#include "core/solver/lanes/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

#include "core/solver/lanes/passes.h"
#include "tests/core/solver/strip.h"

namespace toile {
namespace {

struct Shaken {
  solver::ClothModel model;
  std::vector<double> w;
  std::vector<Vec3> x;
};

/// A rectangle of `height` mm, bent, stretched, pushed together and shaken out of shape; one vertex is held,
/// one triangle has collapsed.
Shaken shaken(double strain_limit = 0, double height = 70) {
  material::Fabric fabric;
  fabric.bend_warp *= 3;
  fabric.limit_warp = fabric.limit_weft = fabric.limit_shear = strain_limit;
  const test::Strip strip = test::make_strip({0, 90, 130}, height, 0.008, {0, 1}, fabric);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shake(-2e-3, 2e-3);
  Shaken s{strip.model, {}, {}};
  for (const Vec2& p : strip.rest)
    s.x.push_back({1.02 * p.x + shake(random) + 3, shake(random), 0.7 * p.y + shake(random)});
  for (const double m : strip.model.mass) s.w.push_back(1 / m);
  s.w[5] = 0;
  const Tri& flat = strip.model.triangles[7];
  s.x[flat[1]] = s.x[flat[2]] = s.x[flat[0]];
  return s;
}

std::vector<Vec3> swept(const Shaken& s, const solver::lanes::LaneKernels& kernels, int threads = 1) {
  Crew crew(threads);
  solver::lanes::MembranePass membrane(s.model);
  solver::lanes::BendPass bending(s.model);
  membrane.prepare(s.w, 1.0 / 3000);
  bending.prepare(s.w, 1.0 / 3000);
  std::vector<Vec3> x = s.x;
  std::vector<solver::lanes::LanePoint> points;
  for (int i = 0; i < 20; ++i) {
    solver::lanes::spread(x, points, crew);
    membrane.solve(points, i % 2 == 0, crew, kernels);
    bending.solve(points, crew, kernels);
    solver::lanes::collect(points, x, crew);
    if (i % 2 == 0) membrane.learn(x, 0.1);
  }
  return x;
}

/// Every set of kernels that runs here makes the same bytes of it as the plain one.
void expect_same_bytes(const Shaken& s) {
  const std::vector<Vec3> plain = swept(s, solver::lanes::kPlainLaneKernels);
  EXPECT_NE(std::memcmp(plain.data(), s.x.data(), plain.size() * sizeof(Vec3)), 0);
  const auto sets = solver::lanes::runnable_lane_kernels();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::vector<Vec3> other = swept(s, *sets[i]);
    EXPECT_EQ(std::memcmp(plain.data(), other.data(), plain.size() * sizeof(Vec3)), 0) << "set " << i;
  }
}

TEST(Lanes, MakeTheSameBytesOnEveryProcessor) {
  if (solver::lanes::runnable_lane_kernels().size() < 2)
    GTEST_SKIP() << "SKIPPED: no other kernels here to compare with";
  for (const double strain_limit : {0.0, 0.02}) {
    for (const double height : {8.0, 20.0, 45.0, 70.0}) expect_same_bytes(shaken(strain_limit, height));
  }
}

TEST(Lanes, MakeTheSameBytesOfFewTriangles) {
  const Shaken all = shaken(0.02);
  for (std::size_t count = 1; count < 2 * solver::lanes::kLanes + 2; ++count) {
    Shaken s = all;
    s.model.triangles.resize(count);
    s.model.rest.resize(count);
    s.model.fabric_of_triangle.resize(count);
    expect_same_bytes(s);
  }
}

TEST(Lanes, ANegativeZeroLeavesNoTrace) {
  Shaken s = shaken();
  for (Vec3& p : s.x) p.y = -0.0;
  expect_same_bytes(s);
  for (const Vec3& p : swept(s, solver::lanes::lane_kernels())) EXPECT_FALSE(std::signbit(p.y));
}

TEST(Lanes, TheWidestSetIsChosen) {
  EXPECT_EQ(&solver::lanes::lane_kernels(), solver::lanes::runnable_lane_kernels().back());
}

TEST(Lanes, LeaveNumbersAndHeldVerticesInPlace) {
  const Shaken s = shaken();
  const std::vector<Vec3> x = swept(s, solver::lanes::lane_kernels());
  EXPECT_EQ(x[5], s.x[5]);
  for (const Vec3& p : x) EXPECT_TRUE(is_finite(p));
}

TEST(Lanes, AGroupSharesNoVertexAndEveryConstraintIsInOne) {
  const Shaken s = shaken(0, 140);
  std::vector<Index> all(s.model.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const auto groups = solver::lanes::group_apart(
      all, s.model.vertex_count(), [&](Index t) { return std::span<const Index>(s.model.triangles[t]); });
  std::vector<int> seen(s.model.triangles.size(), 0);
  int lanes = 0;
  for (const solver::lanes::LaneGroup& group : groups) {
    std::vector<int> used(static_cast<std::size_t>(s.model.vertex_count()), 0);
    EXPECT_NE(group[0], kNone);
    for (const Index t : group) {
      if (t == kNone) continue;
      ++seen[t];
      ++lanes;
      for (const Index v : s.model.triangles[t]) EXPECT_EQ(++used[v], 1);
    }
  }
  for (const int n : seen) EXPECT_EQ(n, 1);
  EXPECT_GT(lanes, 7.0 / 8 * solver::lanes::kLanes * static_cast<double>(groups.size()))
      << "packs are nearly full";
}

/// Two sheets of n × n vertices with their triangles in no order, as sewn pieces have them.
std::vector<Tri> two_sheets(Index n, std::mt19937& random) {
  std::vector<Tri> triangles;
  for (const Index first : {0, n * n}) {
    for (Index i = 0; i + 1 < n; ++i) {
      for (Index j = 0; j + 1 < n; ++j) {
        const Index v = first + i * n + j;
        triangles.push_back({v, v + 1, v + n});
        triangles.push_back({v + 1, v + n + 1, v + n});
      }
    }
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  return triangles;
}

TEST(Lanes, StripsSideBySideShareNoVertexAndEveryConstraintIsInOne) {
  std::mt19937 random(5);
  for (const Index n : {20, 90}) {  // what is not worth it, and what is
    const std::vector<Tri> triangles = two_sheets(n, random);
    const auto count = static_cast<Index>(triangles.size());
    const solver::lanes::PackPlan plan = solver::lanes::plan_packs(
        count, 2 * n * n, [&](Index t) { return std::span<const Index>(triangles[t]); });
    std::vector<int> seen(triangles.size(), 0);
    for (const auto& strips : plan.rounds) {
      std::vector<int> strip_of(static_cast<std::size_t>(2 * n * n), -1);
      for (std::size_t k = 0; k < strips.size(); ++k) {
        for (std::size_t g = strips[k].begin; g < strips[k].end; ++g) {
          EXPECT_EQ(plan.side[g], static_cast<Index>(k));
          for (const Index t : plan.groups[g]) {
            if (t == kNone) continue;
            ++seen[t];
            for (const Index v : triangles[t]) {
              EXPECT_TRUE(strip_of[v] == -1 || strip_of[v] == static_cast<int>(k));
              strip_of[v] = static_cast<int>(k);
            }
          }
        }
      }
    }
    for (const int times : seen) EXPECT_EQ(times, 1);
    EXPECT_LE(plan.rounds[0].size(), static_cast<std::size_t>(solver::lanes::kMostSideBySide));
    EXPECT_EQ(plan.rounds[0].size() > 8, n == 90);
    EXPECT_EQ(plan.rounds[1].empty(), n == 20);
  }
}

TEST(Lanes, MakeTheSameBytesOnAnyNumberOfThreads) {
  const Shaken s = shaken(0, 3600);
  ASSERT_GT(s.model.triangles.size(), 12000u);
  const std::vector<Vec3> alone = swept(s, solver::lanes::lane_kernels());
  for (const int threads : {2, 4}) {
    const std::vector<Vec3> shared = swept(s, solver::lanes::lane_kernels(), threads);
    EXPECT_EQ(std::memcmp(alone.data(), shared.data(), alone.size() * sizeof(Vec3)), 0) << threads;
  }
}

TEST(Lanes, ConstraintsThatAllShareAVertexStandAlone) {
  const std::vector<Tri> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  const std::vector<Index> all{0, 1, 2};
  const auto groups =
      solver::lanes::group_apart(all, 5, [&](Index t) { return std::span<const Index>(fan[t]); });
  ASSERT_EQ(groups.size(), 3u);
  for (Index t = 0; t < 3; ++t) {
    solver::lanes::LaneGroup alone;
    alone.fill(kNone);
    alone[0] = t;
    EXPECT_EQ(groups[t], alone);
  }
}

}  // namespace
}  // namespace toile
