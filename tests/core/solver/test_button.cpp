#include "core/solver/constraints/button.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace toile {
namespace {

/// Two triangles of unit masses, facing each other at a distance along z.
std::vector<Vec3> two_triangles(double distance) {
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, distance}, {1, 0, distance}, {0, 1, distance}};
}
const std::vector<double> kUnit(6, 1.0);

/// A tie whose `end` is its length now.
solver::constraints::PointTie tie(double start, double end) {
  return {{{0, 1, 2}, {0.5, 0.25, 0.25}}, {{3, 4, 5}, {0.2, 0.3, 0.5}}, start, end};
}
constexpr double kMobility = 0.25 + 2 * 0.0625 + 0.04 + 0.09 + 0.25;

double tied_length(const solver::constraints::PointTie& t, std::span<const Vec3> x) {
  return length(sewing::position_of(t.b, x) - sewing::position_of(t.a, x));
}

TEST(Button, DrawsItsPointsToTheLengthThatIsLeft) {
  for (const double open : {1.0, 0.5, 0.0}) {
    std::vector<Vec3> x = two_triangles(0.2);
    solver::constraints::PointTie t = tie(0.2, 0.01);
    t.closing_force = t.holding_force = 1e9;
    const double h = 1;                        // long enough for the whole way
    const double slanted = tied_length(t, x);  // its points do not lie face to face
    solver::constraints::solve_ties(std::vector{t}, open, kUnit, h, x);
    EXPECT_NEAR(tied_length(t, x), std::min(slanted, 0.01 + 0.19 * open), 1e-12);
    Vec3 sum;
    for (std::size_t i = 0; i < 6; ++i) sum += x[i] - two_triangles(0.2)[i];
    EXPECT_LT(length(sum), 1e-12) << "a thread pulls on both ends alike";
  }
}

TEST(Button, IsSlackWhereItsPointsAreNear) {
  std::vector<Vec3> x = two_triangles(0.001);
  const std::vector<Vec3> before = x;
  solver::constraints::PointTie t = tie(0.2, 0.01);
  t.b.share = t.a.share;
  solver::constraints::solve_ties(std::vector{t}, 0, kUnit, 1e-3, x);
  EXPECT_EQ(x, before);
}

TEST(Button, ClosesGentlyAndHoldsFirmly) {
  const double h = 1e-3;
  const auto drawn = [&](double excess) {
    std::vector<Vec3> x = two_triangles(1);
    solver::constraints::PointTie t = tie(0, 0);
    const double now = tied_length(t, x);
    t.end_length = now - excess;
    solver::constraints::solve_ties(std::vector{t}, 0, kUnit, h, x);
    return now - tied_length(t, x);
  };
  EXPECT_NEAR(drawn(0.1), 1 * h * h * kMobility, 1e-12) << "1 N on the way";
  EXPECT_NEAR(drawn(1e-3), 50 * h * h * kMobility, 1e-12) << "50 N when it is closed";
}

TEST(Button, NeverFliesShut) {
  std::vector<double> light(6, 1e5);
  std::vector<Vec3> x = two_triangles(0.3);
  solver::constraints::PointTie t = tie(0, 0.01);
  const double before = tied_length(t, x);
  solver::constraints::solve_ties(std::vector{t}, 0, light, 1e-3, x);
  EXPECT_NEAR(before - tied_length(t, x), solver::constraints::kTieSpeed * 1e-3, 1e-9);
}

}  // namespace
}  // namespace toile
