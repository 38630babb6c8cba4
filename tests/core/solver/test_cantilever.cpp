// A strip that bends under its own weight (ASTM D1388, ISO 9073-7). An overhang of L = 2·(B/w)^(1/3), with w
// the weight per area, makes the chord from the clamp to the tip fall by 41.5°.

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/core/solver/strip.h"

namespace toile {
namespace {

constexpr double kOverhang = 0.1, kGravity = 9.81;

/// Rigidity with which the overhang is 0.1 m.
double rigidity_for(double areal_mass) {
  const double half = kOverhang / 2;
  return half * half * half * areal_mass * kGravity;
}

/// Degrees by which the chord falls at rest. Cloth is clamped on vertices, so that its slope is held at the
/// middle of the row of triangles before them: the overhang counts from half a row (√3/4 of an edge) inside
/// the clamp.
double chord_angle(Fabric fabric, Vec2 grain, double h, double rate) {
  const double clamp = 0.03 + std::sqrt(3.0) / 4 * h;
  const test::Strip strip = test::make_strip({0, 1e3 * clamp, 130}, 25, h, grain, fabric);
  std::vector<Vec3> x;
  std::vector<HeldVertex> held;
  for (const Vec2& p : strip.rest) {
    x.push_back({p.x - 0.03, 0, p.y});
    if (p.x <= clamp + 1e-6) held.push_back({static_cast<Index>(x.size()) - 1, false, x.back()});
  }
  ClothSolver solver(strip.model, x, {}, 1 / rate);
  solver.set_holds(held);
  StepForces forces;
  forces.damping = 12;
  for (int i = 0; i < 3 * rate; ++i) solver.step(forces);
  Vec3 tip;
  int count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (strip.rest[i].x > 0.1299) tip += solver.positions()[i], ++count;
  }
  tip = tip * (1.0 / count);
  return degrees_from_radians(std::atan2(-tip.y, tip.x));
}

Fabric stiff_along_warp_only() {
  Fabric fabric;
  fabric.areal_mass = 0.2;
  const double b = rigidity_for(fabric.areal_mass);
  fabric.bend_warp = b, fabric.bend_weft = b / 8;
  fabric.bend_bias = (fabric.bend_warp + fabric.bend_weft) / 2;
  return fabric;
}

TEST(Cantilever, FallsByTheStandardsAngleAlongTheWarpOnEveryMesh) {
  EXPECT_NEAR(chord_angle(stiff_along_warp_only(), {1, 0}, 0.007, 6000), 41.5, 2.2);
  EXPECT_NEAR(chord_angle(stiff_along_warp_only(), {1, 0}, 0.005, 12000), 41.5, 2.2);
}

TEST(Cantilever, FallsByTheStandardsAngleAlongTheWeft) {
  Fabric fabric = stiff_along_warp_only();
  std::swap(fabric.bend_warp, fabric.bend_weft);
  EXPECT_NEAR(chord_angle(fabric, {0, 1}, 0.007, 6000), 41.5, 2.2);
}

}  // namespace
}  // namespace toile
