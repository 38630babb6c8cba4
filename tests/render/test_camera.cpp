#include "server/render/camera.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/render/draped.h"

namespace toile {
namespace {

constexpr render::View kViews[] = {render::View::kFront, render::View::kBack, render::View::kSide,
                                   render::View::kThreeQuarter};

Aabb3 picture_box(const render::Camera& camera, const std::vector<Vec3>& points, int width, int height) {
  Aabb3 box;
  for (const Vec3& p : points) box.add(camera.project(p, width, height));
  return box;
}

TEST(Camera, NeverCropsTheGarmentAndLeavesAMargin) {
  const Draped skirt = folded_skirt();
  for (const render::View view : kViews) {
    for (const double aspect : {0.5, 0.8, 2.0}) {
      const auto width = static_cast<int>(1000 * aspect);
      const Aabb3 box =
          picture_box(render::frame_scene(skirt.scene(), view, aspect), skirt.positions, width, 1000);
      EXPECT_GT(box.low.x, 0.05 * width);
      EXPECT_LT(box.high.x, 0.95 * width);
      EXPECT_GT(box.low.y, 50);
      EXPECT_LT(box.high.y, 950);
      EXPECT_GT(box.low.z, 0);
    }
  }
}

TEST(Camera, ShowsTheGarmentLarge) {
  const Draped skirt = folded_skirt();
  for (const render::View view : kViews) {
    const Aabb3 box = picture_box(render::frame_scene(skirt.scene(), view, 0.8), skirt.positions, 800, 1000);
    EXPECT_GT(std::max((box.high.x - box.low.x) / 800, (box.high.y - box.low.y) / 1000), 0.70);
  }
}

TEST(Camera, LooksAtASmallGarmentCloselyAndAtALargeOneWithTheWholeBody) {
  Draped skirt = folded_skirt();
  const geometry::TriangleMesh body = form();
  render::Scene scene = skirt.scene();
  scene.bodies.push_back({&body});
  const Aabb3 close =
      picture_box(render::frame_scene(scene, render::View::kFront, 0.8), body.vertices, 800, 1000);
  EXPECT_LT(close.low.y, 0);

  for (Vec3& p : skirt.positions) p.y = 1.4 - 2.4 * (1 - p.y);  // down to 0.2 m
  const Aabb3 wide =
      picture_box(render::frame_scene(scene, render::View::kFront, 0.8), body.vertices, 800, 1000);
  EXPECT_GT(wide.low.y, 0);
  EXPECT_LT(wide.high.y, 1000);
}

TEST(Camera, ShowsTheBodysLeftFromTheSide) {
  const Draped skirt = folded_skirt();
  EXPECT_GT(render::frame_scene(skirt.scene(), render::View::kFront, 1).eye.z, 1);
  EXPECT_LT(render::frame_scene(skirt.scene(), render::View::kBack, 1).eye.z, -1);
  EXPECT_GT(render::frame_scene(skirt.scene(), render::View::kSide, 1).eye.x,
            1);  // facing +z with y up, left is +x
}

TEST(Camera, LooksDownOnWhatLiesFlat) {
  Draped disc = folded_skirt();
  for (Vec3& p : disc.positions) p.y = 0.5;
  const render::Camera camera = render::frame_scene(disc.scene(), render::View::kFront, 1);
  EXPECT_GT(camera.back.y, 0.5);
}

TEST(Camera, ProjectsAsItsMatrixDoes) {
  const render::Camera camera = render::frame_scene(folded_skirt().scene(), render::View::kThreeQuarter, 0.8);
  const render::Matrix4 m = camera.matrix();
  const Vec3 p{0.1, 0.7, -0.05};
  const double in[4] = {p.x, p.y, p.z, 1};
  double clip[4] = {};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) clip[row] += m[4 * column + row] * in[column];
  }
  const Vec3 pixel = camera.project(p, 800, 1000);
  EXPECT_NEAR((clip[0] / clip[3] + 1) * 400, pixel.x, 1e-2);
  EXPECT_NEAR((1 - clip[1] / clip[3]) * 500, pixel.y, 1e-2);
  EXPECT_NEAR(clip[3], pixel.z, 1e-4);
  EXPECT_LT(std::abs(clip[2] / clip[3]), 1);
}

TEST(Camera, KeepsAParallelMapWithinItsBounds) {
  const Draped skirt = folded_skirt();
  const render::Matrix4 m =
      render::parallel_matrix(render::cloth_box(skirt.scene()), normalized(Vec3{0.3, -1, -0.2}));
  for (const Vec3& p : skirt.positions) {
    for (int row = 0; row < 3; ++row) {
      EXPECT_LE(std::abs(m[row] * p.x + m[4 + row] * p.y + m[8 + row] * p.z + m[12 + row]), 1.0001);
    }
  }
}

TEST(Camera, StandsWhereItIsPutAndLooksAtTheTarget) {
  const render::Camera camera = *render::camera_at({}, {.eye = {1, 2, 3}, .target = Vec3{0, 1, 0}}, 1.0);
  const Vec3 middle = camera.project({0, 1, 0}, 200, 200), above = camera.project({0, 1.1, 0}, 200, 200);
  EXPECT_NEAR(middle.x, 100, 1e-9);
  EXPECT_NEAR(middle.y, 100, 1e-9);
  EXPECT_NEAR(above.x, 100, 1e-9);
  EXPECT_LT(above.y, 100);
}

TEST(Camera, LooksStraightDownWithTheFrontBelow) {
  const render::Camera camera = *render::camera_at({}, {.eye = {0, 3, 0}, .target = Vec3{0, 1, 0}}, 1.0);
  EXPECT_GT(camera.project({0, 1, 0.1}, 200, 200).y, 100);
}

TEST(Camera, IsRefusedWhereItCannotStand) {
  EXPECT_EQ(render::camera_at({}, {.eye = {0, 1, 0}, .target = Vec3{0, 1, 0}}, 1.0).error().code,
            "render.camera");
  EXPECT_EQ(render::camera_at({}, {.eye = {0, 1, 500}}, 1.0).error().code, "render.camera");
  EXPECT_EQ(render::camera_at({}, {.eye = {0, 1, 2}, .angle = 0.5}, 1.0).error().code, "render.camera");
}

TEST(Camera, HasAWordForEachView) {
  for (const std::string& word : render::view_words()) EXPECT_TRUE(render::view_from(word).ok()) << word;
  EXPECT_EQ(render::view_from("below").error().code, "render.view");
}

}  // namespace
}  // namespace toile
