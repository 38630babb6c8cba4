// Pictures on cloth, in stills.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "server/render/still.h"
#include "server/render/surface_vertices.h"
#include "tests/core/image/pictures.h"
#include "tests/render/draped.h"
#include "tests/render/one_still.h"

namespace toile {
namespace {

constexpr render::StillSettings kSize{400, 400, 4};

/// A sheet of 0.4 m by 0.4 m that hangs before the camera; flat coordinates count from its lower left corner,
/// which lies at (-0.2, 1) in space.
struct Sheet {
  std::vector<Vec3> positions{{-0.2, 1, 0}, {0.2, 1, 0}, {0.2, 1.4, 0}, {-0.2, 1.4, 0}};
  std::vector<Tri> triangles{{0, 1, 2}, {0, 2, 3}};
  std::vector<Vec2> rest{{0, 0}, {0.4, 0}, {0.4, 0.4}, {0, 0.4}};
  image::Textures textures;

  Sheet(const image::PanelTexture& texture, const image::Picture& picture) {
    image::TextureImage image;
    image.read.picture = picture;
    image.read.width = picture.width;
    image.read.height = picture.height;
    textures.images = {std::make_shared<const image::TextureImage>(image)};
    textures.of_panel = {texture};
  }
  render::Scene scene() const {
    render::Scene scene;
    scene.cloth = {positions, triangles, {}, {}, {{0.05, 0.3, 0.05}}, rest, &textures};
    return scene;
  }
  /// The colour that is seen at a flat place.
  std::array<int, 3> at(const render::Image& image, Vec2 flat) const {
    const render::Camera camera = render::frame_scene(scene(), render::View::kFront, 1);
    const Vec3 p = camera.project({flat.x - 0.2, 1 + flat.y, 0}, kSize.width, kSize.height);
    const std::size_t i = (static_cast<std::size_t>(p.y) * kSize.width + static_cast<std::size_t>(p.x)) * 3;
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
  }
};

char colour_of(std::array<int, 3> c) {
  const auto [r, g, b] = c;
  if (r > b + 40) return 'r';
  if (b > r + 40) return 'b';
  return g > r + 25 && g > b + 25 ? 'g' : 'w';
}

/// Colours at the middles of 20 mm squares of a row, from the left.
std::string row_of(const Sheet& sheet, const render::Image& image, double y) {
  std::string row;
  for (double x = 0.01; x < 0.4; x += 0.02) row += colour_of(sheet.at(image, {x, y}));
  return row;
}

render::Image still(const Sheet& sheet) {
  Result<render::Image> image = test::render_still(sheet.scene(), render::View::kFront, kSize);
  EXPECT_TRUE(image.ok()) << to_string(image.error());
  return image.ok() ? std::move(*image) : render::Image{};
}

TEST(TexturedStill, ShowsSquaresOfTheirSizeUprightAndUnmirrored) {
  const Sheet sheet(image::lay_texture(0, {0, 1}, {}, 0.04, 1, 0), test::squares(64));
  const render::Image image = still(sheet);
  // Red is the picture's upper left square, blue its lower right one.
  EXPECT_EQ(row_of(sheet, image, 0.01), "wbwbwbwbwbwbwbwbwbwb");
  EXPECT_EQ(row_of(sheet, image, 0.03), "rwrwrwrwrwrwrwrwrwrw");
  EXPECT_EQ(row_of(sheet, image, 0.21), "wbwbwbwbwbwbwbwbwbwb");
}

TEST(TexturedStill, BeginsAtItsOffset) {
  const Sheet sheet(image::lay_texture(0, {0, 1}, {0.02, 0}, 0.04, 1, 0), test::squares(64));
  const render::Image image = still(sheet);
  EXPECT_EQ(row_of(sheet, image, 0.01), "bwbwbwbwbwbwbwbwbwbw");
}

TEST(TexturedStill, TurnsWithTheGrainAndByItsAngle) {
  // The warp lies along +x: the picture's upright does too, and its lower right corner comes to the lower
  // left.
  const Sheet lying(image::lay_texture(0, {1, 0}, {}, 0.04, 1, 0), test::squares(64));
  EXPECT_EQ(row_of(lying, still(lying), 0.03), "wrwrwrwrwrwrwrwrwrwr");
  EXPECT_EQ(row_of(lying, still(lying), 0.01), "bwbwbwbwbwbwbwbwbwbw");
  const Sheet back(image::lay_texture(0, {1, 0}, {}, 0.04, 1, kPi / 2), test::squares(64));
  EXPECT_EQ(row_of(back, still(back), 0.01), "wbwbwbwbwbwbwbwbwbwb");
}

TEST(TexturedStill, LetsTheClothShineThrough) {
  const image::Picture lace = test::painted(8, 8, [](int x, int) -> std::array<int, 4> {
    return {200, 30, 20, x < 4 ? 255 : 0};
  });
  const Sheet sheet(image::lay_texture(0, {0, 1}, {}, 0.04, 1, 0), lace);
  EXPECT_EQ(row_of(sheet, still(sheet), 0.21), "rgrgrgrgrgrgrgrgrgrg");
}

TEST(TexturedStill, OfFineSquaresIsAnEvenTone) {
  const Sheet sheet(image::lay_texture(0, {0, 1}, {}, 0.0005, 1, 0), test::squares(64));
  const render::Image image = still(sheet);
  const std::array<int, 3> one = sheet.at(image, {0.1, 0.2}), other = sheet.at(image, {0.13, 0.213});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(one[c], other[c], 12);
}

TEST(TexturedStill, LeavesPanelsWithoutAPictureAsTheyWere) {
  const Draped skirt = folded_skirt();
  Sheet sheet(image::lay_texture(0, {0, 1}, {}, 0.04, 1, 0), test::squares(64));
  sheet.textures.of_panel = {std::nullopt, sheet.textures.of_panel[0]};
  render::Scene scene = skirt.scene();
  const render::Image plain = *test::render_still(scene, render::View::kFront, kSize);
  scene.cloth.textures = &sheet.textures;
  const render::Image half = *test::render_still(scene, render::View::kFront, kSize);
  const std::size_t middle = (std::size_t{200} * 400 + 200) * 3;
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(plain.rgb[middle + c], half.rgb[middle + c]);
  EXPECT_NE(plain.rgb, test::render_still(scene, render::View::kBack, kSize)->rgb);
}

TEST(TexturedStill, RefusesPicturesThatAreNotThere) {
  Sheet sheet(image::lay_texture(3, {0, 1}, {}, 0.04, 1, 0), test::squares());
  EXPECT_EQ(test::render_still(sheet.scene(), render::View::kFront, kSize).error().code, "render.bad_index");
  image::Picture cut = test::squares();
  cut.rgba.pop_back();
  const Sheet broken(image::lay_texture(0, {0, 1}, {}, 0.04, 1, 0), cut);
  EXPECT_EQ(test::render_still(broken.scene(), render::View::kFront, kSize).error().code, "render.bad_scene");
}

TEST(ClothRuns, PutTrianglesOfOnePictureTogether) {
  Draped skirt = folded_skirt();
  image::Textures textures;
  textures.images = {std::make_shared<const image::TextureImage>(),
                     std::make_shared<const image::TextureImage>()};
  textures.of_panel = {image::lay_texture(1, {0, 1}, {}, 0.1, 1, 0),
                       image::lay_texture(0, {0, 1}, {}, 0.1, 1, 0)};
  render::Scene scene = skirt.scene();
  const std::vector<render::ClothRun> plain = render::cloth_surface(scene.cloth).runs;
  ASSERT_EQ(plain.size(), 1u);
  EXPECT_EQ(plain[0].image, kNone);
  scene.cloth.textures = &textures;
  const render::ClothSurface surface = render::cloth_surface(scene.cloth);
  const std::vector<render::ClothRun>& runs = surface.runs;
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].image, 0);
  EXPECT_EQ(runs[1].image, 1);
  EXPECT_EQ(runs[1].first, runs[0].count);
  EXPECT_EQ(runs[0].count + runs[1].count, static_cast<int>(3 * skirt.triangles.size()));
  // The back comes first now: its vertices are those of the second half of the triangles.
  const render::ClothVertex& first = surface.vertices[static_cast<std::size_t>(surface.triangles[0][0])];
  EXPECT_NEAR(first.position[2], skirt.positions[skirt.triangles[skirt.triangles.size() / 2][0]].z, 1e-6);
}

}  // namespace
}  // namespace toile
