// A strip that bends under its own weight (ASTM D1388, ISO 9073-7). An overhang of L = 2·(B/w)^(1/3), with w
// the weight per area, makes the chord from the clamp to the tip fall by 41.5°.

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/material/elastic_line.h"
#include "tests/core/solver/strip.h"

namespace toile {
namespace {

constexpr double kOverhang = 0.1, kInside = 0.01, kStandard = 41.5, kTolerance = 2.2;

/// Rigidity with which the overhang is 0.1 m.
double rigidity_for(double areal_mass) {
  const double half = kOverhang / 2;
  return half * half * half * areal_mass * kGravity;
}

/// Points along a strip of `load` w / B, fine enough to be the answer known beforehand.
std::vector<Vec2> elastica(double load) { return material::elastic_line(load, 2000); }

double chord_fall(Vec2 tip) { return degrees_from_radians(std::atan2(-tip.y, tip.x)); }

/// Degrees by which the chord falls at rest. Cloth is clamped on vertices, so that its slope is held at the
/// middle of the row of triangles before them: the overhang counts from half a row (√3/4 of an edge) inside
/// the clamp. It starts as a strip of `start_rigidity` times its own would hang, and has `seconds` to find
/// its own way.
double chord_angle(const material::Fabric& fabric, Vec2 grain, double h, double width, double start_rigidity,
                   double rate, double seconds) {
  const double clamp = kInside + std::sqrt(3.0) / 4 * h, end = 1e3 * (kInside + kOverhang);
  const test::Strip strip = test::make_strip({0, 1e3 * clamp, end}, width, h, grain, fabric);
  const std::vector<Vec2> start = elastica(8 / start_rigidity);
  std::vector<Vec3> x;
  std::vector<solver::constraints::HeldVertex> held;
  for (const Vec2& p : strip.rest) {
    const double s = std::max(0.0, (p.x - clamp) / (1e-3 * end - clamp));
    const Vec2 at = start[static_cast<std::size_t>(std::lround(s * (static_cast<double>(start.size()) - 1)))];
    const double scale = 1e-3 * end - clamp;
    const bool inside = p.x <= clamp + 1e-6;
    x.push_back(inside ? Vec3{p.x - kInside, 0, p.y}
                       : Vec3{clamp - kInside + scale * at.x, scale * at.y, p.y});
    if (inside) held.push_back({static_cast<Index>(x.size()) - 1, false, x.back()});
  }
  solver::ClothSolver solver(strip.model, x, {}, 1 / rate);
  solver.set_holds(held);
  solver::StepForces forces;
  forces.damping = 12;
  for (int i = 0; i < seconds * rate; ++i) solver.step(forces);
  Vec3 tip;
  int count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (strip.rest[i].x > 1e-3 * end - 1e-4) {
      tip += solver.positions()[i];
      ++count;
    }
  }
  tip = tip * (1.0 / count);
  return chord_fall({tip.x, tip.y});
}

material::Fabric stiff_along_warp_only() {
  material::Fabric fabric;
  fabric.areal_mass = 0.2;
  const double b = rigidity_for(fabric.areal_mass);
  fabric.bend_warp = b;
  fabric.bend_weft = b / 8;
  fabric.bend_bias = (fabric.bend_warp + fabric.bend_weft) / 2;
  return fabric;
}

material::Fabric stiff_along_weft_only() {
  material::Fabric fabric = stiff_along_warp_only();
  std::swap(fabric.bend_warp, fabric.bend_weft);
  return fabric;
}

constexpr Vec2 kAlong{1, 0}, kAcross{0, 1};  // the warp against the strip's length

TEST(Cantilever, TheStandardsAngleIsThatOfTheElasticLine) {
  EXPECT_NEAR(chord_fall(elastica(8).back()), kStandard, 0.2);
}

TEST(Cantilever, FallsByTheStandardsAngleAlongTheWarpAt10Mm) {
  EXPECT_NEAR(chord_angle(stiff_along_warp_only(), kAlong, 0.010, 30, 1e3, 4500, 2), kStandard, kTolerance);
}

TEST(Cantilever, FallsByTheStandardsAngleAlongTheWeftAt10Mm) {
  EXPECT_NEAR(chord_angle(stiff_along_weft_only(), kAcross, 0.010, 30, 1e3, 4500, 2), kStandard, kTolerance);
}

TEST(Cantilever, FallsByTheStandardsAngleAlongTheWarpAt5Mm) {
  EXPECT_NEAR(chord_angle(stiff_along_warp_only(), kAlong, 0.005, 20, 2, 9000, 1), kStandard, kTolerance);
}

TEST(Cantilever, FallsByTheStandardsAngleAlongTheWeftAt5Mm) {
  EXPECT_NEAR(chord_angle(stiff_along_weft_only(), kAcross, 0.005, 20, 2, 9000, 1), kStandard, kTolerance);
}

TEST(Cantilever, FallsByTheStandardsAngleAlongTheWarpAt2HalfMm) {
  EXPECT_NEAR(chord_angle(stiff_along_warp_only(), kAlong, 0.0025, 10, 1.3, 22000, 0.4), kStandard,
              kTolerance);
}

TEST(Cantilever, FallsByTheStandardsAngleAlongTheWeftAt2HalfMm) {
  EXPECT_NEAR(chord_angle(stiff_along_weft_only(), kAcross, 0.0025, 10, 1.3, 22000, 0.4), kStandard,
              kTolerance);
}

}  // namespace
}  // namespace toile
