#include "core/solver/constraints/bend.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "core/base/units.h"
#include "core/solver/lanes/passes.h"
#include "tests/core/solver/strip.h"

namespace toile {
namespace {

/// Energy of the jumps: ½ jᵀ C⁻¹ j, summed over the triangles.
double bending_energy(const std::vector<solver::constraints::BendTriangle>& triangles,
                      const std::vector<Vec3>& x) {
  double energy = 0;
  for (const solver::constraints::BendTriangle& t : triangles) {
    constexpr int kEntry[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    std::vector<int> present;
    for (int k = 0; k < 3; ++k) {
      if (t.v[3 + k] != kNone) present.push_back(k);
    }
    const auto n = static_cast<Eigen::Index>(present.size());
    Eigen::MatrixXd compliance(n, n), jumps(n, 3);
    for (Eigen::Index a = 0; a < n; ++a) {
      const int k = present[a];
      Vec3 j = x[t.v[3 + k]] * t.far[k];
      for (int i = 0; i < 3; ++i) j += x[t.v[i]] * t.own[k][i];
      jumps.row(a) << j.x, j.y, j.z;
      for (Eigen::Index b = 0; b < n; ++b) compliance(a, b) = t.compliance[kEntry[k][present[b]]];
    }
    energy += 0.5 * (jumps.transpose() * compliance.ldlt().solve(jumps)).trace();
  }
  return energy;
}

material::Fabric anisotropic() {
  material::Fabric fabric;
  fabric.bend_warp = 4e-5;
  fabric.bend_weft = 1e-5;
  fabric.bend_bias = 2e-5;
  return fabric;
}

/// A 20 cm square bent to a cylinder of radius 0.2 m whose generators are across the direction u.
double energy_per_area_of_cylinder(Vec2 u, double h) {
  const test::Strip strip = test::make_strip({0, 200}, 200, h, {0, 1}, anisotropic());
  constexpr double kRadius = 0.2;
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) {
    const double s = dot(p, u), v = cross(u, p);
    x.push_back({kRadius * std::sin(s / kRadius), kRadius * std::cos(s / kRadius), v});
  }
  return bending_energy(solver::constraints::make_bending(strip.model), x) / (0.2 * 0.2);
}

TEST(Bend, ACylindersEnergyIsItsRigidityInEachDirectionOnAnyMesh) {
  constexpr double kHalfCurvatureSquared = 0.5 / (0.2 * 0.2);
  const double bias = std::sqrt(0.5);
  for (const double h : {0.011, 0.006}) {  // the border's triangles know less: it converges with h
    EXPECT_NEAR(energy_per_area_of_cylinder({0, 1}, h) / kHalfCurvatureSquared, 4e-5, 4e-5 * 3 * h / 0.1);
    EXPECT_NEAR(energy_per_area_of_cylinder({1, 0}, h) / kHalfCurvatureSquared, 1e-5, 1e-5 * 3 * h / 0.1);
    EXPECT_NEAR(energy_per_area_of_cylinder({bias, bias}, h) / kHalfCurvatureSquared, 2e-5,
                2e-5 * 3 * h / 0.1);
  }
}

TEST(Bend, AFlatSheetHasNoEnergyHoweverItIsTurnedOrSheared) {
  const test::Strip strip = test::make_strip({0, 100}, 100, 0.01, {0, 1}, anisotropic());
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest)
    x.push_back({0.8 * p.x + 0.3 * p.y + 1, 0.6 * p.x - 0.2 * p.y, 0.9 * p.y - 2});
  EXPECT_NEAR(bending_energy(solver::constraints::make_bending(strip.model), x), 0, 1e-18);
}

TEST(Bend, BendsOnAcrossASeamAsIfTheClothWereWhole) {
  material::Fabric fabric = anisotropic();
  const test::Strip whole = test::make_strip({0, 200}, 100, 0.008, {1, 0}, fabric);
  const test::Strip sewn = test::make_strip({0, 70, 140, 200}, 100, 0.008, {1, 0}, fabric);
  const auto energy = [](const test::Strip& strip) {
    std::vector<Vec3> x;
    for (const Vec2& p : strip.rest) x.push_back({0.1 * std::sin(p.x / 0.1), 0.1 * std::cos(p.x / 0.1), p.y});
    return bending_energy(solver::constraints::make_bending(strip.model), x);
  };
  EXPECT_NEAR(energy(sewn) / energy(whole), 1, 0.03);
}

/// What turns a wing of two triangles back that are folded by `degrees` along their common edge: its moment
/// over that of its weights, from one pass of a step so short that it is the force.
double moment_of_fold(double degrees) {
  solver::ClothModel model;
  model.fabrics = {material::Fabric{}};
  model.triangles = {{0, 1, 2}, {1, 0, 3}};
  model.rest = {{Vec2{0, 0}, Vec2{0.01, 0}, Vec2{0.005, 0.008}},
                {Vec2{0.01, 0}, Vec2{0, 0}, Vec2{0.005, -0.008}}};
  model.fabric_of_triangle = {0, 0};
  model.mass.assign(4, 1e-5);
  solver::lanes::BendPass bending(model);
  bending.prepare(std::vector<double>(4, 1e5), 1e-6);
  const double angle = radians_from_degrees(degrees);
  const Vec3 arm{0, -0.008 * std::cos(angle), 0.008 * std::sin(angle)};
  std::vector<Vec3> x{{0, 0, 0}, {0.01, 0, 0}, {0.005, 0.008, 0}, Vec3{0.005, 0, 0} + arm};
  const Vec3 before = x[3];
  test::sweep(bending, x);
  return cross(arm, x[3] - before).x;
}

TEST(Bend, ASharpFoldTurnsBackAsHardAsItsAngle) {
  const double gentle = moment_of_fold(20) / 20;
  ASSERT_GT(gentle, 0);
  for (const double degrees : {60.0, 90.0, 120.0, 150.0, 165.0}) {
    EXPECT_GT(moment_of_fold(degrees) / degrees, 0.8 * gentle) << degrees;
    EXPECT_LT(moment_of_fold(degrees) / degrees, 1.35 * gentle) << degrees;
  }
}

TEST(Bend, APassNeitherMovesTheCentreOfMassNorTurnsTheCloth) {
  test::Strip strip = test::make_strip({0, 60}, 40, 0.01, {0, 1}, anisotropic());
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shake(-1e-3, 1e-3);
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) x.push_back({p.x + shake(random), shake(random), p.y + shake(random)});
  std::vector<double> w;
  for (const double m : strip.model.mass) w.push_back(1 / m);
  solver::lanes::BendPass bending(strip.model);
  bending.prepare(w, 1.0 / 3000);
  const std::vector<Vec3> before = x;
  test::sweep(bending, x);
  Vec3 momentum, turning;
  double moved = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 d = (x[i] - before[i]) * strip.model.mass[i];
    momentum += d;
    turning += cross(before[i], d);
    moved += length(d);
  }
  EXPECT_GT(moved, 0);
  EXPECT_LT(length(momentum), 1e-6 * moved) << "weights are floats";
  EXPECT_LT(length(turning), 1e-2 * moved * 0.06) << "jumps act along themselves, lever arms nearly so";
}

}  // namespace
}  // namespace toile
