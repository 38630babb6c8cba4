#include "core/drape/weld.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// Two triangles whose edges (0, 1) and (3, 4) are sewn, lying side by side with a gap.
sewing::GarmentMesh two_triangles() {
  sewing::GarmentMesh g;
  g.rest.resize(6);
  g.triangles = {{0, 1, 2}, {4, 3, 5}};
  g.sewn = {{0, 3}, {1, 4}};
  g.weld = {0, 1, 2, 0, 1, 5};
  return g;
}

std::vector<Vec3> side_by_side(double gap) {
  return {{0, 0, 0}, {0.1, 0, 0}, {0.05, 0.1, 0}, {0, -gap, 0}, {0.1, -gap, 0}, {0.05, -0.1, 0}};
}

TEST(Weld, SewnVerticesBecomeOneInTheMiddle) {
  const drape::Weld w = drape::weld_seams(two_triangles(), side_by_side(2e-4), 5e-4, {});
  EXPECT_EQ(w.vertex_count, 4);
  EXPECT_EQ(w.vertex_of, (std::vector<Index>{0, 1, 2, 0, 1, 3}));
  EXPECT_NEAR(w.positions[0].y, -1e-4, 1e-12);
  EXPECT_TRUE(w.refused.empty());
}

TEST(Weld, WhatIsTooFarApartStaysOpenAndIsSaid) {
  std::vector<Vec3> x = side_by_side(2e-4);
  x[4].y = -0.01;
  const drape::Weld w = drape::weld_seams(two_triangles(), x, 5e-4, {});
  EXPECT_EQ(w.vertex_count, 5);
  EXPECT_EQ(w.refused, (std::vector<Index>{1}));
  EXPECT_EQ(w.positions[w.vertex_of[4]].y, -0.01);
}

TEST(Weld, AWeldThatWouldCrossTheBodyIsNotDone) {
  // A thin wall stands in the gap, so that closing it at vertices 1 and 4 runs cloth through the wall.
  const std::vector<Vec3> wall{
      {0.09, -1e-4, -0.05}, {0.12, -1e-4, -0.05}, {0.09, -1e-4, 0.05}, {0.12, -1e-4, 0.05}};
  const std::vector<collision::CrossingBody> bodies{
      collision::make_crossing_body(wall, std::vector<Tri>{{0, 1, 2}, {1, 3, 2}})};
  std::vector<Vec3> x = side_by_side(2e-4);
  x[2].y = 0.1;
  x[5].y = -0.1;
  x[0].y = 2e-4;
  x[1].y = 2e-4;  // the upper piece above the wall
  x[3].y = -4e-4;
  x[4].y = -8e-4;
  const drape::Weld w = drape::weld_seams(two_triangles(), x, 1e-3, bodies);
  EXPECT_FALSE(w.refused.empty());
  std::vector<Vec3> end;
  for (const Index v : w.vertex_of) end.push_back(w.positions[v]);
  const sewing::GarmentMesh g = two_triangles();
  EXPECT_TRUE(
      collision::body_crossings(collision::make_surface(g.triangles, 6, g.weld), end, bodies[0]).empty());
}

}  // namespace
}  // namespace toile
