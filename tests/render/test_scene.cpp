#include "server/render/scene.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/render/draped.h"

namespace toile {
namespace {

std::string code_of(const render::Scene& scene) {
  const Status status = render::check_scene(scene);
  return status.ok() ? "" : status.error().code + " " + status.error().where;
}

TEST(CheckScene, AcceptsAnEmptySceneAndADrapedOne) {
  const Draped skirt = folded_skirt();
  const geometry::TriangleMesh body = form();
  render::Scene scene = skirt.scene();
  scene.bodies.push_back({&body});
  EXPECT_EQ(code_of(scene), "");
  EXPECT_EQ(code_of({}), "");
}

TEST(CheckScene, RefusesAPositionThatIsNotANumber) {
  Draped skirt = folded_skirt();
  skirt.positions[17].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of(skirt.scene()), "render.not_finite cloth vertex 17");
  geometry::TriangleMesh body = form();
  body.vertices[3].x = std::numeric_limits<double>::infinity();
  render::Scene scene;
  scene.bodies.push_back({&body});
  EXPECT_EQ(code_of(scene), "render.not_finite body 0 vertex 3");
}

TEST(CheckScene, RefusesMillimetresTakenForMetres) {
  Draped skirt = folded_skirt();
  for (Vec3& p : skirt.positions) p = p * 1e3;
  EXPECT_EQ(code_of(skirt.scene()), "");  // a kilometre is far, but can be drawn
  for (Vec3& p : skirt.positions) p = p * 1e3;
  EXPECT_EQ(code_of(skirt.scene()), "render.too_far cloth vertex 0");
}

TEST(CheckScene, RefusesIndicesThatLeadNowhere) {
  Draped skirt = folded_skirt();
  skirt.triangles[5][1] = static_cast<Index>(skirt.positions.size());
  EXPECT_EQ(code_of(skirt.scene()), "render.bad_index cloth triangle 5");
  skirt = folded_skirt();
  skirt.weld[2] = -1;
  EXPECT_EQ(code_of(skirt.scene()), "render.bad_index cloth vertex 2");
}

TEST(CheckScene, RefusesArraysOfDifferentLength) {
  Draped skirt = folded_skirt();
  skirt.weld.pop_back();
  EXPECT_EQ(code_of(skirt.scene()), "render.bad_scene weld");
  skirt = folded_skirt();
  skirt.panel_of_triangle.pop_back();
  EXPECT_EQ(code_of(skirt.scene()), "render.bad_scene panel_of_triangle");
  render::Scene scene;
  scene.bodies.push_back({});
  EXPECT_EQ(code_of(scene), "render.bad_scene body 0");
}

TEST(FloorHeight, IsTheLowestPointUnlessItIsGiven) {
  const Draped skirt = folded_skirt();
  render::Scene scene = skirt.scene();
  EXPECT_DOUBLE_EQ(render::floor_height(scene), 0.5);
  const geometry::TriangleMesh body = form();
  scene.bodies.push_back({&body});
  EXPECT_DOUBLE_EQ(render::floor_height(scene), 0);
  scene.floor = -0.3;
  EXPECT_DOUBLE_EQ(render::floor_height(scene), -0.3);
  EXPECT_DOUBLE_EQ(render::floor_height({}), 0);
}

}  // namespace
}  // namespace toile
