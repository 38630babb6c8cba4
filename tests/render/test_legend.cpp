#include "server/render/legend.h"

#include <gtest/gtest.h>

#include "server/render/still.h"

namespace toile::render {
namespace {

Image grey(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width * height), 128)};
}

Rgb8 pixel(const Image& image, int x, int y) {
  const auto at = 3 * static_cast<std::size_t>(y * image.width + x);
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

int count_of(const Image& image, Rgb8 colour) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += pixel(image, x, y) == colour ? 1 : 0;
  return count;
}

TEST(Letters, HaveWidthAndStrokes) {
  EXPECT_EQ(strokes_of("").size(), 0U);
  EXPECT_EQ(strokes_of("L").size(), 2U);
  EXPECT_EQ(strokes_of("l").size(), 2U) << "a capital in its place";
  EXPECT_GT(strokes_of("°").size(), 3U);
  EXPECT_EQ(strokes_of("~").size(), 0U);
  EXPECT_NEAR(width_of("0"), 4 / 6.0, 1e-12);
  EXPECT_NEAR(width_of("00"), 10 / 6.0, 1e-12);
  for (const Stroke& stroke : strokes_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789kam%°.-/")) {
    EXPECT_GE(stroke.from.y, 0);
    EXPECT_LE(stroke.from.y, 1);
  }
}

TEST(Letters, AreDrawnWhereTheyWereAskedFor) {
  Image image = grey(60, 40);
  draw_words(image, "L", 10, 30, 20, {0, 0, 0});
  EXPECT_EQ(pixel(image, 10, 20), (Rgb8{0, 0, 0})) << "its stem";
  EXPECT_EQ(pixel(image, 20, 29), (Rgb8{0, 0, 0})) << "its foot";
  EXPECT_EQ(pixel(image, 20, 15), (Rgb8{128, 128, 128})) << "nothing between";
  draw_words(image, "WWWWWWWW", -30, 10, 20, {0, 0, 0});  // what lies outside is left out
}

TEST(Legend, ShowsEachColourAndItsBounds) {
  const Legend legend{"Stretch", "%", {{200, 0, 0}, {0, 200, 0}}, {"-1", "0", "1"}};
  Image image = grey(400, 300);
  draw_legend(image, legend);
  const int red = count_of(image, {200, 0, 0}), green = count_of(image, {0, 200, 0});
  EXPECT_GT(red, 500);
  EXPECT_NEAR(green, red, 80);
  EXPECT_EQ(pixel(image, 399, 0), (Rgb8{128, 128, 128})) << "the rest of the picture stays";
  Image tiny = grey(16, 16);
  draw_legend(tiny, legend);
}

TEST(Legend, IsSeenOnATransparentPicture) {
  const Legend legend{"Stretch", "%", {{200, 0, 0}}, {"0", "1"}};
  Image image = grey(200, 200);
  image.opacity.assign(200 * 200, 0);
  draw_legend(image, legend);
  EXPECT_EQ(count_of(image, {200, 0, 0}) > 0, true);
  std::size_t opaque = 0;
  for (const std::uint8_t o : image.opacity) opaque += o == 255 ? 1 : 0;
  EXPECT_GT(opaque, 500U);
  EXPECT_EQ(image.opacity[199], 0);
}

TEST(Legend, NothingIsDrawnWithoutColours) {
  Image image = grey(50, 50);
  draw_legend(image, {});
  EXPECT_EQ(image.rgb, grey(50, 50).rgb);
}

}  // namespace
}  // namespace toile::render
