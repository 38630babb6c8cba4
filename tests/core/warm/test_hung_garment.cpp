#include "core/warm/hung_garment.h"

#include <gtest/gtest.h>

#include <limits>

namespace toile {
namespace {

warm::HungGarment square() {
  warm::HungPiece piece;
  piece.id = "front";
  piece.rest = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  piece.triangles = {{0, 1, 2}, {0, 2, 3}};
  piece.edges = {{"hem", {0, 1}}, {"side", {1, 2}}};
  piece.positions = {{0, 0, 0.5}, {1, 0, 0}, {1, 1, 0}, {0, 1, -3}};
  piece.preloads = {{0.1, 0, 0}, {0, 0.2, 0}};
  return {{piece}};
}

TEST(HungGarment, ComesBackFromItsBytes) {
  const warm::HungGarment back = warm::decode_hung(warm::encode_hung(square())).value();
  ASSERT_EQ(back.pieces.size(), 1U);
  const warm::HungPiece piece = square().pieces[0];
  EXPECT_EQ(back.pieces[0].id, piece.id);
  EXPECT_EQ(back.pieces[0].rest, piece.rest);
  EXPECT_EQ(back.pieces[0].triangles, piece.triangles);
  EXPECT_EQ(back.pieces[0].positions, piece.positions);
  EXPECT_EQ(back.pieces[0].preloads, piece.preloads);
  ASSERT_EQ(back.pieces[0].edges.size(), 2U);
  EXPECT_EQ(back.pieces[0].edges[1].id, "side");
  EXPECT_EQ(back.pieces[0].edges[1].vertices, (std::vector<Index>{1, 2}));
}

warm::HungGarment pinned() {
  warm::HungGarment hung = square();
  hung.pins = {{"front", {0.25, 0.5}}, {"front", {1, 0}}};
  return hung;
}

TEST(HungGarment, ComesBackWithItsPins) {
  EXPECT_EQ(warm::decode_hung(warm::encode_hung(pinned()))->pins, pinned().pins);
  const std::string plain = warm::encode_hung(square()), with = warm::encode_hung(pinned());
  EXPECT_EQ(plain[8], 1) << "a garment without has the bytes that it had before there were pins";
  EXPECT_EQ(with[8], 2);
  EXPECT_TRUE(warm::decode_hung(plain)->pins.empty());
}

TEST(HungGarment, IsRefusedWhenItsPinsMakeNoSense) {
  const auto refused = [](const auto& spoil) {
    warm::HungGarment bad = pinned();
    spoil(bad.pins[1]);
    const auto read = warm::decode_hung(warm::encode_hung(bad));
    return !read.ok() && read.error().code == "hung.damaged";
  };
  EXPECT_TRUE(refused([](warm::HungPin& p) { p.piece = "back"; }));
  EXPECT_TRUE(refused([](warm::HungPin& p) { p.at.y = std::numeric_limits<double>::infinity(); }));
  warm::HungGarment many = square();
  many.pins.assign(warm::kMostHungPins, {"front", {0, 0}});
  EXPECT_TRUE(warm::decode_hung(warm::encode_hung(many)));
  many.pins.push_back({"front", {0, 0}});
  EXPECT_FALSE(warm::decode_hung(warm::encode_hung(many)));
  const std::string bytes = warm::encode_hung(pinned());
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_EQ(warm::decode_hung(bytes.substr(0, n)).error().code, "hung.damaged");
}

TEST(HungGarment, IsRefusedWhenItIsCutOffOrChangedAnywhere) {
  const std::string bytes = warm::encode_hung(square());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    EXPECT_EQ(warm::decode_hung(bytes.substr(0, n)).error().code, "hung.damaged");
    std::string changed = bytes;
    changed[n] = static_cast<char>(changed[n] ^ 4);
    EXPECT_FALSE(warm::decode_hung(changed).ok()) << n;
  }
  EXPECT_FALSE(warm::decode_hung(bytes + "x").ok());
}

TEST(HungGarment, IsRefusedWhenItsNumbersMakeNoSenseThoughItsHashIsRight) {
  const auto refused = [](const auto& spoil) {
    warm::HungGarment bad = square();
    spoil(bad.pieces[0]);
    const auto read = warm::decode_hung(warm::encode_hung(bad));
    return !read.ok() && read.error().code == "hung.damaged";
  };
  EXPECT_TRUE(refused([](warm::HungPiece& p) { p.triangles[1][2] = 4; }));
  EXPECT_TRUE(refused([](warm::HungPiece& p) { p.triangles[0][0] = -1; }));
  EXPECT_TRUE(refused([](warm::HungPiece& p) { p.edges[0].vertices[1] = 9; }));
  EXPECT_TRUE(refused([](warm::HungPiece& p) { p.edges[0].vertices.clear(); }));
  EXPECT_TRUE(refused([](warm::HungPiece& p) { p.positions.pop_back(); }));
  EXPECT_TRUE(refused([](warm::HungPiece& p) { p.preloads.pop_back(); }));
  EXPECT_TRUE(
      refused([](warm::HungPiece& p) { p.positions[0].y = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(refused([](warm::HungPiece& p) { p.rest[0].x = 1e300; }));
}

}  // namespace
}  // namespace toile
