#include "server/render/cloth_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace toile {
namespace {

using render::Structure;

TEST(ClothLook, FollowsFromAFabricsWords) {
  EXPECT_EQ(render::look_from("woven", "2/1 twill", "denim cotton", 0.7e-3).structure, Structure::kTwill);
  EXPECT_EQ(render::look_from("knit", "single jersey", "jersey", 0.6e-3).structure, Structure::kKnit);
  EXPECT_EQ(render::look_from("woven", "cut pile", "velvet", 1e-3).structure, Structure::kFelt);
  EXPECT_EQ(render::look_from("", "", "", 0.5e-3).structure, Structure::kPlain);
  EXPECT_LT(render::look_from("woven", "satin", "silk satin", 0.2e-3).roughness, 0.5f);
  EXPECT_GT(render::look_from("woven", "plain", "wool flannel", 0.9e-3).sheen, 0.4f);
}

TEST(ClothLook, HasCoarserThreadsOnThickerCloth) {
  const float shirt = render::look_from("woven", "plain", "poplin", 0.25e-3).pitch;
  const float canvas = render::look_from("woven", "plain", "canvas", 0.9e-3).pitch;
  EXPECT_NEAR(shirt, 0.15e-3, 0.02e-3) << "about 65 threads a centimetre";
  EXPECT_GT(canvas, 2 * shirt);
}

TEST(WeaveTile, IsLevelAndOfFullToneOnTheWhole) {
  for (int s = 0; s < render::kStructures; ++s) {
    const std::vector<std::uint8_t> tile = render::weave_tile(static_cast<Structure>(s));
    ASSERT_EQ(tile.size(), 4u * render::kWeaveSide * render::kWeaveSide);
    std::array<double, 4> mean{};
    int least = 255, most = 0;
    for (std::size_t i = 0; i < tile.size(); ++i) {
      mean[i % 4] += tile[i] * 4.0 / static_cast<double>(tile.size());
      if (i % 4 == 0) least = std::min(least, int{tile[i]});
      if (i % 4 == 0) most = std::max(most, int{tile[i]});
    }
    EXPECT_NEAR(mean[0], 128, 3) << s << ": from afar the cloth is flat";
    EXPECT_NEAR(mean[1], 128, 3) << s;
    EXPECT_NEAR(mean[2], 204, 3) << s << ": and keeps its colour";
    EXPECT_GT(most - least, 20) << s << ": threads stand up";
  }
}

TEST(WeaveTile, RepeatsWithoutAStep) {
  constexpr int kSide = render::kWeaveSide;
  for (int s = 0; s < render::kStructures; ++s) {
    const std::vector<std::uint8_t> tile = render::weave_tile(static_cast<Structure>(s));
    const auto tone = [&](int x, int y) {
      return int{tile[static_cast<std::size_t>(4 * (y * kSide + x) + 2)]};
    };
    int inside = 0, across = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x + 1 < kSide; ++x) inside = std::max(inside, std::abs(tone(x, y) - tone(x + 1, y)));
      across = std::max(across, std::abs(tone(kSide - 1, y) - tone(0, y)));
    }
    EXPECT_LE(across, inside + 2) << s;
  }
}

}  // namespace
}  // namespace toile
