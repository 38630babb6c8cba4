#include "core/solver/cloth_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "tests/core/solver/strip.h"

namespace toile {
namespace {

/// The strip flat in the x-z plane at height y.
double mean_height(const solver::ClothSolver& solver) {
  double sum = 0;
  for (const Vec3& p : solver.positions()) sum += p.y;
  return sum / static_cast<double>(solver.positions().size());
}

void run(solver::ClothSolver& solver, const solver::StepForces& forces, double seconds) {
  const int steps = static_cast<int>(seconds / solver.time_step());
  for (int i = 0; i < steps; ++i) solver.step(forces);
}

solver::StepForces damped(double damping) {
  solver::StepForces forces;
  forces.damping = damping;
  return forces;
}

TEST(ClothSolver, ALooseSheetFallsAsEverythingDoes) {
  const test::Strip strip = test::make_strip({0, 100}, 100, 0.02, {0, 1}, material::Fabric{});
  solver::ClothSolver solver(strip.model, lying(strip, 1), {}, 1.0 / 2000);
  run(solver, damped(0), 0.4);
  EXPECT_NEAR(mean_height(solver), 1 - 0.5 * 9.81 * 0.16, 2e-3);
}

double breadth(const solver::ClothSolver& solver) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& p : solver.positions()) {
    low = std::min(low, p.x);
    high = std::max(high, p.x);
  }
  return high - low;
}

TEST(ClothSolver, AShapeTakenForRestHasNoStressUntilItIsLetGoOf) {
  const test::Strip strip = test::make_strip({0, 100}, 100, 0.02, {0, 1}, material::Fabric{});
  std::vector<Vec3> x = lying(strip, 1);
  for (Vec3& p : x) p.x *= 1.3;
  solver::ClothSolver solver(strip.model, x, {}, 1.0 / 2000);
  solver::StepForces forces = damped(20);
  forces.gravity = 0;
  forces.learns = false;
  solver.rest_here();
  run(solver, forces, 0.1);
  EXPECT_NEAR(breadth(solver), 0.13, 1e-4);
  const auto come_back = [&](int from, int to) {  // per cent of the way that are left
    for (int left = from; left > to; --left) {
      solver.keep_preloads((left - 1.0) / left);
      run(solver, forces, 0.01);
    }
  };
  come_back(100, 50);
  EXPECT_NEAR(breadth(solver), 0.115, 2e-3) << "half of the way back";
  come_back(50, 0);
  EXPECT_NEAR(breadth(solver), 0.1, 2e-3);
}

/// A square table of the given size, tilted about z.
collision::Obstacle slope(double angle, double friction) {
  const double c = std::cos(angle), s = std::sin(angle), half = 0.5;
  std::vector<Vec3> x;
  for (const double u : {-half, half}) {
    for (const double v : {-half, half}) x.push_back({u * c, u * s, v});
  }
  return collision::make_obstacle(x, std::vector<Tri>{{0, 1, 2}, {1, 3, 2}}, friction, 1e-3);
}

/// Way along a slope of `angle` within half a second, m.
double slide(double angle, double friction) {
  const test::Strip strip = test::make_strip({0, 80}, 80, 0.02, {0, 1}, material::Fabric{});
  const Vec3 along{std::cos(angle), std::sin(angle), 0}, up{-std::sin(angle), std::cos(angle), 0};
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) x.push_back(along * (p.x - 0.04) + up * 1.05e-3 + Vec3{0, 0, p.y - 0.04});
  const std::vector<collision::Obstacle> obstacles{slope(angle, friction)};
  solver::ClothSolver solver(strip.model, x, obstacles, 1.0 / 2000);
  run(solver, damped(0), 0.5);
  double way = 0;
  for (std::size_t i = 0; i < x.size(); ++i) way -= dot(solver.positions()[i] - x[i], along);
  return way / static_cast<double>(x.size());
}

TEST(ClothSolver, ASheetSlidesFromTheAngleOfFrictionWithinADegree) {
  const double degree = radians_from_degrees(1);
  for (const double friction : {0.2, 0.4, 0.7}) {
    const double angle = std::atan(friction);
    EXPECT_LT(slide(angle - degree, friction), 1e-3) << friction;
    // Half a degree's worth of a free slide: it must go, not creep.
    EXPECT_GT(slide(angle + degree, friction), 0.5 * 9.81 * std::sin(degree / 2) * 0.25) << friction;
  }
}

TEST(ClothSolver, ASheetSlidesFreelyWithoutFriction) {
  EXPECT_NEAR(slide(0.3, 0), 0.5 * 9.81 * std::sin(0.3) * 0.25, 0.02);
}

/// A plane of `cell` m squares around the start of a slide by `angle`, long enough for `way` m down it.
collision::Obstacle long_slope(double angle, double way, double cell, double friction) {
  const Vec3 along{-std::cos(angle), -std::sin(angle), 0};
  const int rows = static_cast<int>((way + 1) / cell) + 1, columns = static_cast<int>(0.5 / cell) + 1;
  std::vector<Vec3> x;
  std::vector<Tri> triangles;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= columns; ++j) x.push_back(along * (i * cell - 0.5) + Vec3{0, 0, j * cell - 0.25});
  }
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) {
      const Index v = i * (columns + 1) + j, below = v + columns + 1;
      triangles.push_back({v, below, v + 1});
      triangles.push_back({v + 1, below, below + 1});
    }
  }
  return collision::make_obstacle(x, triangles, friction, 1e-3);
}

struct Slide {
  double way, speed;  ///< m, m/s, mean of the sheet down the slope
};

/// Of a sheet of `edge` m triangles, laid down on the slope.
Slide long_slide(double angle, double friction, double edge, double cell, double seconds) {
  const test::Strip strip = test::make_strip({0, 200}, 200, edge, {0, 1}, material::Fabric{});
  const Vec3 along{-std::cos(angle), -std::sin(angle), 0}, up{-std::sin(angle), std::cos(angle), 0};
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) x.push_back(along * (0.1 - p.x) + up * 1.01e-3 + Vec3{0, 0, p.y - 0.1});
  const double a = 9.81 * (std::sin(angle) - friction * std::cos(angle));
  const std::vector<collision::Obstacle> obstacles{
      long_slope(angle, 0.5 * a * seconds * seconds, cell, friction)};
  solver::ClothSolver solver(strip.model, x, obstacles, 1.0 / 3000);
  run(solver, damped(0), seconds);
  Slide slide{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    slide.way += dot(solver.positions()[i] - x[i], along) / static_cast<double>(x.size());
    slide.speed += dot(solver.velocities()[i], along) / static_cast<double>(x.size());
  }
  return slide;
}

TEST(ClothSolver, BoundsDoNotBrakeWhatSlides) {
  const double angle = radians_from_degrees(19);
  struct Sheet {
    double edge, cell;  // m, of the cloth and of the ground
  };
  for (const double friction : {0.0, 0.3}) {
    for (const Sheet& sheet : {Sheet{0.02, 1}, {0.02, 0.03}, {0.01, 1}}) {
      const double seconds = friction > 0 ? 2 : 1;
      const double a = 9.81 * (std::sin(angle) - friction * std::cos(angle));
      const Slide slide = long_slide(angle, friction, sheet.edge, sheet.cell, seconds);
      EXPECT_NEAR(slide.speed / (a * seconds), 1, 0.03)
          << friction << ", " << sheet.edge << ", " << sheet.cell;
      EXPECT_NEAR(slide.way / (0.5 * a * seconds * seconds), 1, 0.03) << friction << ", " << sheet.edge;
    }
  }
}

TEST(ClothSolver, AClothOnATableRestsAtTheSkinOffset) {
  const test::Strip strip = test::make_strip({0, 200}, 200, 0.02, {0, 1}, material::Fabric{});
  std::vector<Vec3> x = lying(strip, 0.01);
  for (Vec3& p : x) {
    p.x -= 0.1;
    p.z -= 0.1;
  }
  const std::vector<collision::Obstacle> obstacles{slope(0, 0.4)};
  solver::ClothSolver solver(strip.model, x, obstacles, 1.0 / 2000);
  run(solver, damped(5), 1);
  for (const Vec3& p : solver.positions()) EXPECT_NEAR(p.y, 1e-3, 0.2e-3);
}

TEST(ClothSolver, AStepThatLeavesTheNumbersIsUndoneAndSaid) {
  const test::Strip strip = test::make_strip({0, 40}, 40, 0.02, {0, 1}, material::Fabric{});
  solver::ClothSolver solver(strip.model, lying(strip, 1), {}, 1.0 / 2000);
  std::vector<Vec3> wild(strip.rest.size());
  wild[0] = {std::numeric_limits<double>::infinity(), 0, 0};
  solver.set_velocities(wild);
  EXPECT_TRUE(solver.step(solver::StepForces{}).not_finite);
  for (const Vec3& p : solver.positions()) EXPECT_TRUE(is_finite(p));
}

TEST(ClothSolver, TwoRunsGiveTheSameBytes) {
  const test::Strip strip = test::make_strip({0, 150}, 150, 0.02, {0, 1}, material::Fabric{});
  const auto end = [&] {
    std::vector<Vec3> x = lying(strip, 0.02);
    for (Vec3& p : x) p.x -= 0.4;
    const std::vector<collision::Obstacle> obstacles{slope(0.2, 0.3)};
    solver::ClothSolver solver(strip.model, x, obstacles, 1.0 / 2000);
    run(solver, damped(2), 0.5);
    return solver.positions();
  };
  EXPECT_EQ(end(), end());
}

}  // namespace
}  // namespace toile
