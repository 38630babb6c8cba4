// Stills beside those that were kept when somebody last looked at them and found them good. They may differ
// by what another version of Mesa or another processor rounds otherwise, and by nothing that a person would
// see. TOILE_WRITE_GOLDEN=1 keeps what is drawn now: look at it before you do.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "core/image/read_picture.h"
#include "server/render/png.h"
#include "server/render/still.h"
#include "tests/render/draped.h"
#include "tests/render/one_still.h"

namespace toile {
namespace {

constexpr int kBlock = 4;           // pixels a side: what is seen as one place
constexpr double kMeanApart = 0.7;  // CIE76 units; 2.3 is just noticeable side by side
constexpr double kMostApart = 9;    // of a single block: an edge that moved by a part of a pixel

using Lab = std::array<double, 3>;

double linear(int byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// CIE 1976 L*a*b* of linear sRGB under D65.
Lab lab_of(const std::array<double, 3>& c) {
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
  const double y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
  const double z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.0890);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// The mean colour of each block.
std::vector<Lab> blocks(const render::Image& image) {
  std::vector<Lab> all;
  for (int y = 0; y + kBlock <= image.height; y += kBlock) {
    for (int x = 0; x + kBlock <= image.width; x += kBlock) {
      std::array<double, 3> mean{};
      for (int i = 0; i < kBlock * kBlock; ++i) {
        const int pixel = (y + i / kBlock) * image.width + x + i % kBlock;
        for (int c = 0; c < 3; ++c) mean[c] += linear(image.rgb[3 * pixel + c]) / (kBlock * kBlock);
      }
      all.push_back(lab_of(mean));
    }
  }
  return all;
}

struct Apart {
  double mean = 0, most = 0;
};

Apart apart(const render::Image& a, const render::Image& b) {
  const std::vector<Lab> one = blocks(a), other = blocks(b);
  Apart apart;
  for (std::size_t i = 0; i < one.size(); ++i) {
    double square = 0;
    for (int c = 0; c < 3; ++c) square += std::pow(one[i][c] - other[i][c], 2);
    apart.mean += std::sqrt(square) / static_cast<double>(one.size());
    apart.most = std::max(apart.most, std::sqrt(square));
  }
  return apart;
}

render::Image drawn(render::View view, render::Structure structure) {
  const Draped skirt = folded_skirt();
  const geometry::TriangleMesh body = form();
  render::Scene scene = skirt.scene();
  scene.bodies.push_back({&body});
  scene.cloth.look_of_panel.resize(2);
  for (render::ClothLook& look : scene.cloth.look_of_panel) {
    look = {structure, 0.8e-3f, 2.5e-3f,
            0.5f,      0.3f,    0.02f};  // coarse, so that threads show on a small picture
  }
  return *test::render_still(scene, view, {192, 240, 4});
}

render::Image kept(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto read = image::read_picture(bytes);
  EXPECT_TRUE(read.ok()) << path;
  if (!read) return {};
  const image::Picture& picture = read->picture;
  render::Image image{picture.width, picture.height, {}};
  for (std::size_t i = 0; i < picture.rgba.size(); ++i)
    if (i % 4 != 3) image.rgb.push_back(picture.rgba[i]);
  return image;
}

void compare(const std::string& name, const render::Image& image) {
  const std::string path = TOILE_SOURCE_DIR "/tests/data/stills/" + name + ".png";
  if (std::getenv("TOILE_WRITE_GOLDEN") != nullptr) {
    ASSERT_TRUE(render::write_png(path, image).ok());
    return;
  }
  const render::Image before = kept(path);
  ASSERT_EQ(before.rgb.size(), image.rgb.size()) << path;
  const Apart found = apart(before, image);
  EXPECT_LT(found.mean, kMeanApart) << path;
  EXPECT_LT(found.most, kMostApart) << path;
}

TEST(KeptStills, ShowTheSkirtAsItWasFromTheFront) {
  compare("skirt-front", drawn(render::View::kFront, render::Structure::kPlain));
}

TEST(KeptStills, ShowTheSkirtAsItWasFromTheSide) {
  compare("skirt-side", drawn(render::View::kSide, render::Structure::kTwill));
}

TEST(KeptStills, AreToldFromOthers) {
  const render::Image plain = drawn(render::View::kFront, render::Structure::kPlain);
  render::Image darker = plain;
  for (std::uint8_t& byte : darker.rgb) byte = static_cast<std::uint8_t>(byte * 0.96);
  EXPECT_GT(apart(plain, darker).mean, kMeanApart) << "a little less light";
  render::Image moved = plain;
  std::rotate(moved.rgb.begin(), moved.rgb.begin() + 3 * 4, moved.rgb.end());
  EXPECT_GT(apart(plain, moved).most, kMostApart) << "four pixels aside";
  render::Image speckled = plain;
  for (std::size_t i = 3 * 5000; i < 3 * 5003; ++i) speckled.rgb[i] ^= 4;
  EXPECT_LT(apart(plain, speckled).mean, kMeanApart) << "a pixel or two do not count";
}

}  // namespace
}  // namespace toile
