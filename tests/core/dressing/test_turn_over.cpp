// A shirt's collar around the neck of the sample's mannequin.

#include "core/dressing/turn_over.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/collision/crossings.h"
#include "core/mesh/make_panel_meshes.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

constexpr double kStand = 30, kFall = 45, kAround = 430, kAway = 0.08;  // mm; m from the neck's middle

/// A stand and its fall, sewn standing, the fall pressed back by that angle, degrees.
sewing::Assembly collar(double angle = -170) {
  const measure::BodyFigure& f = test::person().figure;
  pattern::Pattern pattern;
  const auto strip = [](double height) {
    return std::vector<Vec2>{{0, 0}, {kAround, 0}, {kAround, height}, {0, height}};
  };
  pattern.panels = {test::polygon("stand", strip(kStand)), test::polygon("fall", strip(kFall))};
  pattern.seams = {test::seam("s", {{0, 2}}, {{1, 0}})};
  sewing::WrappedPlacement around;
  around.axis = {f.middle, 0, f.neck_front.z - 0.06};
  around.radius = kAway;
  around.angle = kPi;
  around.height = f.neck_front.y + 0.01;
  around.anchor = {kAround / 2e3, 0};
  sewing::WrappedPlacement above = around;
  above.height += kStand / 1e3;
  sewing::Notions notions;
  notions.creases = {{"turned", 1, {0}, {}, angle * kPi / 180, 0.1}};
  return sewing::assemble(mesh::make_panel_meshes(pattern, 0.01, {}).value(), {around, above}, {}, notions)
      .value();
}

double mean_height(std::span<const Vec3> x, Index from, Index to) {
  double sum = 0;
  for (Index v = from; v < to; ++v) sum += x[v].y;
  return sum / (to - from);
}

TEST(TurnOver, AFallComesDownAroundItsStandAndTouchesNothing) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly assembly = collar();
  const sewing::GarmentMesh& g = assembly.garment;
  const std::vector<Vec3>& standing = assembly.positions;
  const std::vector<Vec3> down = dressing::turned_over(assembly, wearer, standing, 1);
  const Index fall = g.first_vertex[1], end = g.first_vertex[2];
  for (Index v = 0; v < fall; ++v) EXPECT_LT(length(down[v] - standing[v]), 1e-6) << "the stand stays";
  const double seam = standing[assembly.pressed_back[0].along.front()].y;
  EXPECT_GT(mean_height(standing, fall, end), seam + 0.4 * kFall / 1e3);
  EXPECT_LT(mean_height(down, fall, end), seam - 0.2 * kFall / 1e3);
  const collision::Surface surface = collision::make_surface(g.triangles, g.vertex_count(), g.weld);
  EXPECT_TRUE(collision::self_crossings(surface, down).empty());
  EXPECT_TRUE(collision::body_crossings(surface, down, wearer.crossing()).empty());
  for (const auto& [i, j] : g.sewn) EXPECT_LT(length(down[i] - down[j]), 1e-6);
}

TEST(TurnOver, TowardsTheNeckThereIsNoRoom) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly inwards = collar(170);
  const std::vector<Vec3> x = dressing::turned_over(inwards, wearer, inwards.positions, 1);
  const Index fall = inwards.garment.first_vertex[1], end = inwards.garment.first_vertex[2];
  const double seam = inwards.positions[inwards.pressed_back[0].along.front()].y;
  EXPECT_GT(mean_height(x, fall, end), seam) << "it is no collar's fall, whose outside comes inside";
}

TEST(TurnOver, GoesAsFarAsItIsToldTo) {
  const dressing::Wearer wearer(test::person());
  const sewing::Assembly assembly = collar();
  const Index fall = assembly.garment.first_vertex[1], end = assembly.garment.first_vertex[2];
  double before = 1e9;
  for (const double share : {0.2, 0.6, 1.0}) {
    const double height =
        mean_height(dressing::turned_over(assembly, wearer, assembly.positions, share), fall, end);
    EXPECT_LT(height, before - 0.004) << share;
    before = height;
  }
  sewing::Assembly none = assembly;
  none.pressed_back.clear();
  EXPECT_EQ(mean_height(dressing::turned_over(none, wearer, none.positions, 1), fall, end),
            mean_height(none.positions, fall, end));
}

}  // namespace
}  // namespace toile
