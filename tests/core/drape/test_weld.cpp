#include "core/drape/weld.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/collision/crossings.h"

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
  const std::vector<Tri> faces{{0, 1, 2}, {1, 3, 2}};
  const std::vector<collision::Obstacle> bodies{collision::make_obstacle(wall, faces, 0.4, 1e-3)};
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
  EXPECT_TRUE(collision::body_crossings(collision::make_surface(g.triangles, 6, g.weld), end,
                                        collision::make_crossing_body(wall, faces))
                  .empty());
}

/// The two triangles, and a third piece whose corner 6 stands `above` (m) the place where 1 and 4 meet.
sewing::GarmentMesh with_a_layer() {
  sewing::GarmentMesh g = two_triangles();
  g.rest.resize(9);
  g.triangles.push_back({6, 7, 8});
  for (const Index v : {6, 7, 8}) g.weld.push_back(v);
  return g;
}

std::vector<Vec3> layer_above(double above) {
  std::vector<Vec3> x = side_by_side(2e-4);
  x[1].z = -1e-4;  // the seam's end closes upwards
  x[4].z = -3e-4;
  const double z = -2e-4 + above;
  for (const Vec3& p : {Vec3{0.099, -1e-4, z}, Vec3{0.11, -0.02, 0.01}, Vec3{0.11, 0.02, 0.01}})
    x.push_back(p);
  return x;
}

TEST(Weld, AWeldEndsBeforeALayerThoughTheCountOfCrossingsWouldRoundItAway) {
  EXPECT_TRUE(drape::weld_seams(with_a_layer(), layer_above(1e-3), 5e-4, {}).refused.empty());
  for (const double above : {-1e-7, 0.0, 1e-7}) {
    const drape::Weld w = drape::weld_seams(with_a_layer(), layer_above(above), 5e-4, {});
    EXPECT_EQ(std::count(w.refused.begin(), w.refused.end(), 1), 1) << above;
  }
}

TEST(Weld, WhatIsJoinedStaysSoWhereNothingIsFree) {
  std::vector<Vec3> x = side_by_side(0);
  for (const Vec3& p : {Vec3{0.1, 1e-7, 1e-6}, Vec3{0.11, -0.02, 0.01}, Vec3{0.11, 0.02, 0.01}})
    x.push_back(p);
  EXPECT_TRUE(drape::weld_seams(with_a_layer(), x, 5e-4, {}).refused.empty());
}

}  // namespace
}  // namespace toile
