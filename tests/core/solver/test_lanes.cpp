#include "core/solver/lanes/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
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

std::vector<Vec3> swept(const Shaken& s, const solver::lanes::LaneKernels& kernels) {
  solver::lanes::MembranePass membrane(s.model);
  solver::lanes::BendPass bending(s.model);
  membrane.prepare(s.w, 1.0 / 3000);
  bending.prepare(s.w, 1.0 / 3000);
  std::vector<Vec3> x = s.x;
  std::vector<solver::lanes::LanePoint> points;
  for (int i = 0; i < 20; ++i) {
    solver::lanes::spread(x, points);
    membrane.solve(points, i % 2 == 0, kernels);
    solver::lanes::collect(points, x);
    if (i % 2 == 0) membrane.learn(x, 0.1);
    test::sweep(bending, x, kernels);
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
  const auto groups =
      solver::lanes::group_apart(static_cast<Index>(s.model.triangles.size()), s.model.vertex_count(),
                                 [&](Index t) { return std::span<const Index>(s.model.triangles[t]); });
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

TEST(Lanes, ConstraintsThatAllShareAVertexStandAlone) {
  const std::vector<Tri> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  const auto groups =
      solver::lanes::group_apart(3, 5, [&](Index t) { return std::span<const Index>(fan[t]); });
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
