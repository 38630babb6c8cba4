#include "core/image/texture.h"

#include <gtest/gtest.h>

#include <numbers>

namespace toile {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_at(const image::PanelTexture& texture, Vec2 flat, double right, double up) {
  const Vec2 found = image::texture_at(texture, flat);
  EXPECT_NEAR(found.x, right, 1e-12);
  EXPECT_NEAR(found.y, up, 1e-12);
}

TEST(Texture, RepeatsEveryWidthAcrossAndEveryHeightUp) {
  const image::PanelTexture texture = image::lay_texture(3, {0, 1}, {0.01, 0.02}, 0.04, 2, 0);
  EXPECT_EQ(texture.image, 3);
  expect_at(texture, {0.01, 0.02}, 0, 0);
  expect_at(texture, {0.05, 0.02}, 1, 0);
  expect_at(texture, {0.01, 0.04}, 0, 1);  // twice as wide as high
  expect_at(texture, {0.03, 0.01}, 0.5, -0.5);
}

TEST(Texture, TurnsWithTheGrain) {
  const image::PanelTexture lying = image::lay_texture(0, {1, 0}, {}, 0.1, 1, 0);
  expect_at(lying, {0.1, 0}, 0, 1);   // up goes along the warp
  expect_at(lying, {0, -0.1}, 1, 0);  // and the width along the weft
}

TEST(Texture, TurnsCounterClockwiseByItsAngle) {
  const image::PanelTexture turned = image::lay_texture(0, {0, 1}, {}, 0.1, 1, kPi / 2);
  expect_at(turned, {-0.1, 0}, 0, 1);
  expect_at(turned, {0, 0.1}, 1, 0);
}

TEST(Texture, IsNoneForPanelsThatNobodySpokeOf) {
  image::Textures textures;
  textures.of_panel = {std::nullopt, image::lay_texture(0, {0, 1}, {}, 1, 1, 0)};
  EXPECT_EQ(image::texture_of(textures, 0), nullptr);
  EXPECT_NE(image::texture_of(textures, 1), nullptr);
  EXPECT_EQ(image::texture_of(textures, 2), nullptr);
  EXPECT_EQ(image::texture_of(textures, kNone), nullptr);
}

}  // namespace
}  // namespace toile
