#include "core/trials/slide.h"

#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/collision/obstacle.h"
#include "core/solver/cloth_solver.h"
#include "core/trials/specimen.h"

namespace toile::trials {
namespace {

constexpr double kSide = 0.1, kSquareSpacing = 0.02;  // m
constexpr double kSteeper = 10;                       // degrees
constexpr double kSkin = 1e-3;                        // m

/// A plane through the origin that falls towards −x, long enough for the way.
collision::Obstacle slope(Vec3 down, double friction) {
  std::vector<Vec3> x;
  for (const double way : {-0.5, 2.5}) {
    for (const double across : {-0.5, 0.5}) x.push_back(down * way + Vec3{0, 0, across});
  }
  return collision::make_obstacle(x, std::vector<Tri>{{0, 2, 1}, {1, 2, 3}}, friction, kSkin);
}

}  // namespace

SlideResult slide(const material::Fabric& fabric) {
  constexpr double kRate = 3000, kSeconds = 0.6;
  SlideResult out;
  out.known = fabric.friction;
  const double angle = std::atan(fabric.friction) + radians_from_degrees(kSteeper);
  const Vec3 down{-std::cos(angle), -std::sin(angle), 0}, up{-std::sin(angle), std::cos(angle), 0};
  const Specimen piece =
      make_specimen(rectangle(mm_from_metres(kSide), mm_from_metres(kSide), {0, 1}), kSquareSpacing, fabric);
  std::vector<Vec3> x;
  for (const Vec2& p : piece.rest)
    x.push_back(down * p.x + up * (1.05 * kSkin) + Vec3{0, 0, p.y - kSide / 2});
  const std::vector<collision::Obstacle> obstacles{slope(down, fabric.friction)};
  solver::ClothSolver solver(piece.model, std::move(x), obstacles, 1 / kRate);
  solver::StepForces forces;
  forces.damping = 0;
  double time = 0;
  for (; time < kSeconds; time += solver.time_step()) solver.step(forces);
  double speed = 0;
  for (const Vec3& v : solver.velocities()) speed += dot(v, down) / static_cast<double>(piece.rest.size());
  out.measured = std::tan(angle) - speed / time / (forces.gravity * std::cos(angle));
  return out;
}

}  // namespace toile::trials
