#include "server/render/still.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/body/mannequin/mannequin.h"
#include "tests/render/draped.h"
#include "tests/render/one_still.h"

namespace toile {
namespace {

constexpr render::StillSettings kSmall{256, 320, 4};

struct Pixel {
  int r, g, b;
};

Pixel at(const render::Image& image, double x, double y) {
  const std::size_t i = (static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x)) * 3;
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

bool is_red(Pixel p) { return p.r > p.b + 30; }
bool is_blue(Pixel p) { return p.b > p.r + 30; }
bool is_grey(Pixel p) { return std::abs(p.r - p.b) < 20; }

render::Image still(const render::Scene& scene, render::View view,
                    const render::StillSettings& settings = kSmall) {
  Result<render::Image> image = test::render_still(scene, view, settings);
  EXPECT_TRUE(image.ok()) << to_string(image.error());
  return image.ok() ? std::move(*image) : render::Image{};
}

TEST(Still, HasTheSizeThatWasAskedFor) {
  const render::Image image = still({}, render::View::kFront, {123, 77, 4});
  EXPECT_EQ(image.width, 123);
  EXPECT_EQ(image.height, 77);
  EXPECT_EQ(image.rgb.size(), 123u * 77 * 3);
}

TEST(Still, OfNothingIsALightStudio) {
  const render::Image image = still({}, render::View::kFront);
  EXPECT_GT(*std::min_element(image.rgb.begin(), image.rgb.end()), 150);
}

TEST(Still, ShowsClothWhereTheCameraProjectsIt) {
  const Draped skirt = folded_skirt();
  const render::Scene scene = skirt.scene();
  const render::Image image = still(scene, render::View::kFront);
  const render::Camera camera = render::frame_scene(scene, render::View::kFront, 256.0 / 320);
  for (const int row : {4, 10, 16}) {
    for (const int column : {12, 20, 28}) {
      const Vec3 p = camera.project(skirt.positions[row * (kSkirtColumns + 1) + column], 256, 320);
      EXPECT_TRUE(is_red(at(image, p.x, p.y))) << row << " " << column;
    }
  }
  for (const auto& [x, y] : {std::pair{4, 4}, {251, 4}, {4, 315}, {251, 315}}) {
    EXPECT_TRUE(is_grey(at(image, x, y)));
  }
}

TEST(Still, ShowsTheOtherPieceFromBehind) {
  const Draped skirt = folded_skirt();
  const render::Image front = still(skirt.scene(), render::View::kFront),
                      back = still(skirt.scene(), render::View::kBack);
  EXPECT_TRUE(is_red(at(front, 128, 160)));
  EXPECT_TRUE(is_blue(at(back, 128, 160)));
}

TEST(Still, PutsTheSeamsInTheMiddleFromTheSide) {
  const Draped skirt = folded_skirt();
  const render::Image side = still(skirt.scene(), render::View::kSide);
  EXPECT_TRUE(is_red(at(side, 90, 160)));  // the front lies to the left when the body's left is seen
  EXPECT_TRUE(is_blue(at(side, 166, 160)));
}

TEST(Still, GivesTheSameBytesTwice) {
  const Draped skirt = folded_skirt();
  const geometry::TriangleMesh body = form();
  render::Scene scene = skirt.scene();
  scene.bodies.push_back({&body});
  const render::Image first = still(scene, render::View::kThreeQuarter);
  EXPECT_EQ(first.rgb, still(scene, render::View::kThreeQuarter).rgb);
  auto fresh = render::StillRenderer::create();
  ASSERT_TRUE(fresh.ok());
  EXPECT_EQ(first.rgb, (*fresh)->render(scene, render::View::kThreeQuarter, kSmall)->rgb);
}

TEST(Still, ShadesTheInsideOfClothDarkerButNotBlack) {
  // A sheet that shows its wrong side to the viewer, against the same sheet turned over.
  std::vector<Vec3> p{{-0.3, 0.5, 0}, {0.3, 0.5, 0}, {0.3, 1.1, 0}, {-0.3, 1.1, 0}};
  const std::vector<Tri> right{{0, 1, 2}, {0, 2, 3}}, wrong{{0, 2, 1}, {0, 3, 2}};
  render::Scene scene;
  scene.cloth = {p, right, {}, {}, {{0.5, 0.1, 0.1}}, {}};
  scene.floor = 0.0;
  const Pixel outside = at(still(scene, render::View::kFront), 128, 160);
  scene.cloth.triangles = wrong;
  const Pixel inside = at(still(scene, render::View::kFront), 128, 160);
  EXPECT_LT(inside.r, outside.r - 5);
  EXPECT_GT(inside.r, 90);
}

TEST(Still, CastsAShadowOnTheGround) {
  const geometry::TriangleMesh body = form();
  render::Scene scene;
  scene.bodies.push_back({&body});
  const render::Camera camera = render::frame_scene(scene, render::View::kFront, 256.0 / 320);
  const render::Image with = still(scene, render::View::kFront), without = still({}, render::View::kFront);
  const Vec3 foot = camera.project({0.13, 0, 0.09}, 256, 320);  // the key light comes from the left
  EXPECT_LT(at(with, foot.x, foot.y).g, at(without, foot.x, foot.y).g - 15);
  EXPECT_NEAR(at(with, 4, 4).g, at(without, 4, 4).g, 2);
}

TEST(Still, ShadowsClothByClothInFrontOfTheLight) {
  const std::vector<Vec3> p{{-0.3, 0.5, 0},     {0.3, 0.5, 0},      {0.3, 1.1, 0},      {-0.3, 1.1, 0},
                            {-0.75, 0.9, 0.35}, {-0.25, 0.9, 0.35}, {-0.25, 1.4, 0.35}, {-0.75, 1.4, 0.35}};
  const std::vector<Tri> both{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}, one{{0, 1, 2}, {0, 2, 3}};
  render::Scene scene;
  scene.cloth = {p, both, {}, {}, {{0.5, 0.1, 0.1}}, {}};
  auto renderer = render::StillRenderer::create();
  ASSERT_TRUE(renderer.ok());
  const render::Camera camera = render::frame_scene(scene, render::View::kFront, 256.0 / 320);
  const render::Image shaded = *(*renderer)->render(scene, camera, kSmall);
  scene.cloth.triangles = one;
  const render::Image open = *(*renderer)->render(scene, camera, kSmall);
  int darker = 0;
  for (double x = -0.25; x < 0.3; x += 0.02) {
    const Vec3 pixel = camera.project({x, 0.8, 0}, 256, 320);
    darker += at(shaded, pixel.x, pixel.y).r < at(open, pixel.x, pixel.y).r - 15;
  }
  EXPECT_GT(darker, 5);
  EXPECT_LT(darker, 27);
}

TEST(Still, HasNoSpecklesOnAnEvenlyLitSheet) {
  const std::vector<Vec3> p{{-0.3, 0.5, 0}, {0.3, 0.5, 0}, {0.3, 1.1, 0}, {-0.3, 1.1, 0}};
  const std::vector<Tri> t{{0, 1, 2}, {0, 2, 3}};
  render::Scene scene;
  scene.cloth = {p, t, {}, {}, {{0.5, 0.1, 0.1}}, {}};
  const render::Image image = still(scene, render::View::kFront);
  for (int y = 120; y < 200; ++y) {
    for (int x = 90; x < 166; ++x) {
      ASSERT_LE(std::abs(at(image, x, y).r - at(image, x + 1, y).r), 3) << x << " " << y;
    }
  }
}

/// Pixels along the middle row that are neither cloth nor backdrop.
int between(const render::Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 1; x + 1 < image.width; ++x) {
      const int left = at(image, x - 1, y).g, here = at(image, x, y).g, right = at(image, x + 1, y).g;
      count += left > here + 25 && here > right + 25;
    }
  }
  return count;
}

TEST(Still, SmoothsEdges) {
  const Draped skirt = folded_skirt();
  const int hard = between(still(skirt.scene(), render::View::kFront, {256, 320, 1}));
  const int smooth = between(still(skirt.scene(), render::View::kFront, {256, 320, 4}));
  const int smoother = between(still(skirt.scene(), render::View::kFront, {256, 320, 16}));
  EXPECT_GT(smooth, hard + 50);
  EXPECT_GT(smoother, hard + 50);
}

/// Across a seam of grey cloth seen from near: with the seam, and the same surface in one piece.
struct AcrossSeam {
  std::vector<int> sewn, joined;  // green, pixel by pixel
};

AcrossSeam across_seam(double metres_off) {
  const Draped skirt = folded_skirt();
  render::Scene scene = skirt.scene();
  scene.cloth.colour_of_panel.assign(2, {0.5, 0.5, 0.5});
  const Vec3 seam = skirt.positions[4 * (kSkirtColumns + 1) + kSkirtColumns];
  const render::Camera camera =
      *render::camera_at(scene, {.eye = seam + Vec3{metres_off, 0, 0}, .target = seam}, 256.0 / 320);
  auto renderer = render::StillRenderer::create();
  const render::Image sewn = *(*renderer)->render(scene, camera, kSmall);
  std::vector<Tri> joined = skirt.triangles;
  for (Tri& t : joined) {
    for (Index& v : t) v = skirt.weld[v];
  }
  scene.cloth.triangles = joined;
  const render::Image plain = *(*renderer)->render(scene, camera, kSmall);
  AcrossSeam across;
  for (int x = 116; x < 140; ++x) {
    across.sewn.push_back(at(sewn, x, 160).g);
    across.joined.push_back(at(plain, x, 160).g);
  }
  return across;
}

TEST(Still, DrawsASeamAsAFineRidgeAndNotAsABlackLine) {
  const AcrossSeam across = across_seam(0.4);
  int darkest = 0, lightest = 0;
  for (std::size_t x = 0; x < across.sewn.size(); ++x) {
    darkest = std::min(darkest, across.sewn[x] - across.joined[x]);
    lightest = std::max(lightest, across.sewn[x] - across.joined[x]);
  }
  EXPECT_LT(darkest, -15) << "the line where the pieces meet";
  EXPECT_GT(darkest, -90) << "not black";
  EXPECT_GT(lightest, 1) << "the side of the ridge that faces the light";
}

TEST(Still, LetsASeamFadeWhereItIsMuchFinerThanAPixel) {
  const AcrossSeam across = across_seam(20);
  for (std::size_t x = 0; x < across.sewn.size(); ++x) EXPECT_NEAR(across.sewn[x], across.joined[x], 8) << x;
}

TEST(Still, WithoutBackdropIsOpaqueWhereThereIsCloth) {
  const Draped skirt = folded_skirt();
  const render::Image image = still(skirt.scene(), render::View::kFront, {256, 320, 4, true});
  ASSERT_EQ(image.opacity.size(), 256u * 320);
  EXPECT_EQ(image.opacity[160 * 256 + 128], 255);
  EXPECT_EQ(image.opacity[4 * 256 + 4], 0);
  EXPECT_TRUE(is_red(at(image, 128, 160)));
  EXPECT_EQ(at(image, 128, 160).r, at(still(skirt.scene(), render::View::kFront), 128, 160).r);
  int shadow = 0;
  for (std::size_t i = 0; i < image.opacity.size(); ++i)
    shadow += image.opacity[i] > 10 && image.opacity[i] < 200 && image.rgb[3 * i] < 8;
  EXPECT_GT(shadow, 100) << "the ground is there as its shadow";
}

/// Pixels of skin, all about them skin as well, that are darker than the mean of two across from each other
/// by more than a round limb's shade can be.
int dashes(const render::Image& image) {
  constexpr int kAround = 3, kDarker = 6;
  const auto skin = [&](int x, int y) { return at(image, x, y).r > at(image, x, y).b + 8; };
  int found = 0;
  for (int y = kAround; y < image.height - kAround; ++y) {
    for (int x = kAround; x < image.width - kAround; ++x) {
      bool within = true;
      for (int dy = -kAround; dy <= kAround && within; dy += kAround)
        for (int dx = -kAround; dx <= kAround && within; dx += kAround) within = skin(x + dx, y + dy);
      if (!within) continue;
      const int mean = (at(image, x, y - kAround).r + at(image, x, y + kAround).r) / 2;
      found += at(image, x, y).r < mean - kDarker;
    }
  }
  return found;
}

// A facet's own depth once put what its smooth shade calls lit into its neighbour's shadow.
TEST(Still, OfAMannequinShowsNoShadowOfItsFacets) {
  mannequin::MannequinSettings settings;
  settings.triangle_count = 3300;
  const auto made = mannequin::make_mannequin(settings);
  ASSERT_TRUE(made.ok());
  render::Scene scene;
  scene.bodies = {{&made->mesh}};
  int found = 0;
  for (const render::View view : {render::View::kFront, render::View::kThreeQuarter}) {
    found += dashes(still(scene, view, {480, 600, 4}));
  }
  EXPECT_LT(found, 150) << "they were 683";
}

TEST(Still, RefusesWhatItCannotDraw) {
  Draped skirt = folded_skirt();
  EXPECT_EQ(test::render_still(skirt.scene(), render::View::kFront, {8, 320, 4}).error().code,
            "render.settings");
  EXPECT_EQ(test::render_still(skirt.scene(), render::View::kFront, {256, 1 << 20, 4}).error().code,
            "render.settings");
  EXPECT_EQ(test::render_still(skirt.scene(), render::View::kFront, {256, 320, 3}).error().code,
            "render.settings");
  skirt.positions[9].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(test::render_still(skirt.scene(), render::View::kFront, kSmall).error().code,
            "render.not_finite");
}

TEST(Still, OfDegenerateClothIsStillAPicture) {
  const std::vector<Vec3> p{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  const std::vector<Tri> t{{0, 1, 2}};
  render::Scene scene;
  scene.cloth = {p, t, {}, {}, {}, {}};
  EXPECT_EQ(still(scene, render::View::kFront).rgb.size(), 256u * 320 * 3);
}

}  // namespace
}  // namespace toile
