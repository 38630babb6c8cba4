#include "core/solver/constraints/fold.h"

#include <gtest/gtest.h>

#include "core/mesh/topology.h"
#include "tests/core/solver/strip.h"

namespace toile {
namespace {

constexpr double kPi = 3.14159265358979;

/// Creases all inner edges of a strip on x = `at` (m) to an angle.
std::vector<solver::constraints::FoldHinge> crease(const test::Strip& strip, double at, double degrees,
                                                   double stiffness) {
  std::vector<solver::constraints::FoldHinge> hinges;
  const auto on_line = [&](Index v) { return std::abs(strip.rest[v].x - at) < 1e-9; };
  for (const mesh::MeshEdge& e : mesh::edges_of(strip.model.triangles, strip.model.vertex_count())) {
    if (e.t1 == kNone || !on_line(e.v0) || !on_line(e.v1)) continue;
    const double half = degrees * kPi / 360;
    hinges.push_back({e.v0, e.v1, e.opposite0, e.opposite1, std::sin(half), std::cos(half),
                      stiffness * length(strip.rest[e.v1] - strip.rest[e.v0])});
  }
  return hinges;
}

/// Degrees between the two wings of a strip folded at x = 0.05, from the directions of their far ends.
double wing_angle(const test::Strip& strip, std::span<const Vec3> x) {
  Vec3 line, left, right;
  int on = 0, l = 0, r = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = strip.rest[i].x;
    if (std::abs(u - 0.05) < 1e-9) {
      line += x[i];
      ++on;
    }
    if (u < 1e-9) {
      left += x[i];
      ++l;
    }
    if (u > 0.1 - 1e-9) {
      right += x[i];
      ++r;
    }
  }
  const Vec3 to_left = normalized(line * (1.0 / on) - left * (1.0 / l));
  const Vec3 to_right = normalized(right * (1.0 / r) - line * (1.0 / on));
  return std::atan2(length(cross(to_left, to_right)), dot(to_left, to_right)) * 180 / kPi;
}

struct Folded {
  double angle;   ///< degrees
  double height;  ///< m, of the wings' ends over the crease, along the flat sheet's normal
};

Folded fold_strip(double degrees, double seconds) {
  const test::Strip strip = test::make_strip({0, 50, 100}, 60, 0.0125, {0, 1}, material::Fabric{});
  std::vector<Vec3> x;
  for (const Vec2& p : strip.rest) x.push_back({p.x, p.y, 0});
  solver::ClothSolver solver(strip.model, x, {}, 1.0 / 2000);
  solver::ClothFeatures features;
  features.folds = crease(strip, 0.05, degrees, 0.02);
  solver.set_features(features);
  solver::StepForces forces;
  forces.gravity = 0;
  forces.damping = 8;
  const int steps = static_cast<int>(seconds * 2000);
  for (int i = 0; i < steps; ++i) {
    forces.features.formed = std::min(1.0, i / (0.25 * steps));
    solver.step(forces);
  }
  double ends = 0, line = 0;
  int e = 0, l = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = strip.rest[i].x;
    if (std::abs(u - 0.05) < 1e-9) {
      line += solver.positions()[i].z;
      ++l;
    }
    if (u < 1e-9 || u > 0.1 - 1e-9) {
      ends += solver.positions()[i].z;
      ++e;
    }
  }
  return {wing_angle(strip, solver.positions()), ends / e - line / l};
}

TEST(Fold, AStripComesToRestAtItsCreasesAngle) {  // less what its own flat bending takes: 3°
  const Folded folded = fold_strip(90, 2);
  EXPECT_NEAR(folded.angle, 90, 5);
  EXPECT_LT(folded.height, -0.02) << "a positive angle keeps the right side outside";
}

TEST(Fold, ANegativeAngleFoldsTheOtherWay) {
  const Folded folded = fold_strip(-60, 2);
  EXPECT_NEAR(folded.angle, 60, 4);
  EXPECT_GT(folded.height, 0.02);
}

TEST(Fold, AStripFoldsFlatOntoItself) {
  const Folded folded = fold_strip(180, 2);
  EXPECT_GT(folded.angle, 160);
}

/// Two triangles hinged on the y axis, the right one turned down by `degrees`.
double difference_at(double degrees, double rest, double pressed) {
  const double a = degrees * kPi / 180, half = rest * kPi / 360;
  const std::vector<Vec3> x{{0, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}, {std::cos(a), 0.5, -std::sin(a)}};
  return solver::constraints::fold_difference({0, 1, 2, 3, std::sin(half), std::cos(half), 1}, pressed, x);
}

TEST(Fold, TheDifferenceIsFourTimesTheTangentOfItsQuarter) {
  const auto expected = [](double degrees) { return 4 * std::tan(degrees * kPi / 720); };
  for (const double rest : {-150.0, -90.0, 0.0, 30.0, 90.0, 180.0}) {
    for (const double angle : {-120.0, -45.0, 0.0, 60.0, 150.0}) {
      EXPECT_NEAR(difference_at(angle, rest, 1), expected(angle - rest), 1e-6) << angle << " at " << rest;
    }
  }
  EXPECT_NEAR(difference_at(20, 120, 0), expected(20), 1e-9) << "not pressed yet: flat";
}

}  // namespace
}  // namespace toile
