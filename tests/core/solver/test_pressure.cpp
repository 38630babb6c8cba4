#include "core/solver/constraints/pressure.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// A box of 2 × 3 × 5 m, far from the origin, normals out.
const std::vector<Vec3> kBox{{10, 20, 30}, {12, 20, 30}, {12, 23, 30}, {10, 23, 30},
                             {10, 20, 35}, {12, 20, 35}, {12, 23, 35}, {10, 23, 35}};
std::vector<Tri> box_skin() {
  return {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
          {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}, {4, 5, 6}, {4, 6, 7}};
}

Vec3 sum_of(const std::vector<Vec3>& forces) {
  Vec3 sum;
  for (const Vec3& f : forces) sum += f;
  return sum;
}

TEST(Pressure, ABoxHasItsVolume) {
  const solver::constraints::PressureChamber chamber =
      solver::constraints::make_chamber(box_skin(), 8, 100, 0);
  EXPECT_TRUE(chamber.openings.empty());
  EXPECT_NEAR(solver::constraints::volume_of(chamber, kBox), 30, 1e-9);
}

TEST(Pressure, APieceThatWindsTheOtherWayIsTurned) {
  std::vector<Tri> skin = box_skin();
  for (std::size_t t = 4; t < 9; ++t) std::swap(skin[t][0], skin[t][1]);
  EXPECT_NEAR(solver::constraints::volume_of(solver::constraints::make_chamber(skin, 8, 100, 0), kBox), 30,
              1e-9);
}

TEST(Pressure, AnOpenBoxIsCappedAndItsForcesCancel) {
  std::vector<Tri> skin = box_skin();
  skin.resize(10);  // without its lid
  const solver::constraints::PressureChamber chamber = solver::constraints::make_chamber(skin, 8, 100, 0);
  ASSERT_EQ(chamber.openings.size(), 1u);
  EXPECT_NEAR(solver::constraints::volume_of(chamber, kBox), 30, 1e-9);
  std::vector<Vec3> forces(8);
  solver::constraints::add_pressure(chamber, 100, kBox, forces);
  EXPECT_LT(length(sum_of(forces)), 1e-9);
  EXPECT_GT(length(forces[0]), 100);
}

TEST(Pressure, ForcesArePressureTimesTheVolumesGradient) {
  std::vector<Tri> skin = box_skin();
  skin.resize(11);  // an opening of three corners
  const solver::constraints::PressureChamber chamber = solver::constraints::make_chamber(skin, 8, 100, 0);
  std::vector<Vec3> forces(8);
  solver::constraints::add_pressure(chamber, 7, kBox, forces);
  for (std::size_t i = 0; i < 8; ++i) {
    for (const Vec3 d : {Vec3{1e-4, 0, 0}, Vec3{0, 1e-4, 0}, Vec3{0, 0, 1e-4}}) {
      std::vector<Vec3> more = kBox, less = kBox;
      more[i] += d;
      less[i] -= d;
      const double gradient =
          (solver::constraints::volume_of(chamber, more) - solver::constraints::volume_of(chamber, less)) /
          2e-4;
      EXPECT_NEAR(dot(forces[i], d) * 1e4, 7 * gradient, 1e-6);
    }
  }
}

TEST(Pressure, AFixedAmountOfAirKeepsPressureTimesVolume) {
  const solver::constraints::PressureChamber chamber =
      solver::constraints::make_chamber(box_skin(), 8, 100, 30);
  EXPECT_NEAR(solver::constraints::pressure_at(chamber, 30), 100, 1e-9);
  EXPECT_NEAR(solver::constraints::pressure_at(chamber, 60), 50, 1e-9);
  EXPECT_NEAR(solver::constraints::pressure_at(chamber, 20), 150, 1e-9);
  EXPECT_NEAR(solver::constraints::pressure_at(chamber, 0), 400, 1e-9) << "flat: filled, not blown up";
  EXPECT_NEAR(solver::constraints::pressure_at(solver::constraints::make_chamber(box_skin(), 8, 100, 0), 1),
              100, 1e-9)
      << "pumped";
}

}  // namespace
}  // namespace toile
