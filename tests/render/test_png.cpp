#include "server/render/png.h"

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

namespace toile {
namespace {

render::Image gradient() {
  render::Image image{7, 5, {}};
  for (int i = 0; i < 7 * 5 * 3; ++i) image.rgb.push_back(static_cast<std::uint8_t>(i * 2));
  return image;
}

TEST(Png, ReadsBackAsItWasWritten) {
  const render::Image image = gradient();
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("toile_gradient_" + std::to_string(::getpid()) + ".png");
  ASSERT_TRUE(render::write_png(path, image).ok());
  png_image read{};
  read.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&read, path.c_str()), 0);
  EXPECT_EQ(read.width, 7u);
  EXPECT_EQ(read.height, 5u);
  read.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(read));
  ASSERT_NE(png_image_finish_read(&read, nullptr, rgb.data(), 0, nullptr), 0);
  EXPECT_EQ(rgb, image.rgb);
  std::filesystem::remove(path);
}

TEST(Png, EqualsTheBytesInMemory) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("toile_memory_" + std::to_string(::getpid()) + ".png");
  ASSERT_TRUE(render::write_png(path, gradient()).ok());
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(bytes, *render::png_bytes(gradient()));
  std::filesystem::remove(path);
}

TEST(Png, RefusesAnImageThatDoesNotFitItsSize) {
  render::Image image = gradient();
  image.rgb.pop_back();
  EXPECT_EQ(render::png_bytes(image).error().code, "render.bad_image");
  EXPECT_EQ(render::png_bytes({}).error().code, "render.bad_image");
  EXPECT_EQ(render::png_bytes({-7, -5, gradient().rgb}).error().code, "render.bad_image");
}

TEST(Png, SaysWhyTheSystemRefused) {
  const Status status = render::write_png("/no/such/folder/a.png", gradient());
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, "export.write");
  EXPECT_EQ(status.error().where, "/no/such/folder/a.png");
}

}  // namespace
}  // namespace toile
