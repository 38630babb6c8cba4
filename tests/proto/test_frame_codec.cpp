#include "proto/cpp/frame_codec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/proto/golden_frames.h"

namespace toile {
namespace {

using Numbers = std::vector<std::int16_t>;

/// A cloth of `vertices` at moment `t`: smooth along its order and in time.
Numbers cloth(int vertices, int t) {
  Numbers numbers;
  for (int v = 0; v < vertices; ++v) {
    numbers.push_back(static_cast<std::int16_t>(3 * v + t));
    numbers.push_back(static_cast<std::int16_t>(900 * std::sin(0.02 * v + 0.05 * t)));
    numbers.push_back(static_cast<std::int16_t>(400 * std::cos(0.03 * v - 0.02 * t)));
  }
  return numbers;
}

std::string encoded(const GoldenFrame& golden) {
  const proto::DecodedFrame& f = golden.frame;
  return f.key ? proto::encode_key(f.header, f.grid) : proto::encode_delta(f.header, f.grid, golden.before);
}

void expect_same(const proto::DecodedFrame& a, const proto::DecodedFrame& b, const std::string& what) {
  EXPECT_EQ(a.key, b.key) << what;
  EXPECT_EQ(a.header.epoch, b.header.epoch) << what;
  EXPECT_EQ(a.header.seq, b.header.seq) << what;
  EXPECT_EQ(a.header.step, b.header.step) << what;
  EXPECT_EQ(a.header.time, b.header.time) << what;
  EXPECT_EQ(a.grid, b.grid) << what;
}

TEST(FrameCodec, WritesTheWorkedExampleOfTheDocumentByteForByte) {
  const std::string key = bytes_of_hex(
      "544c0102"
      "01000000"
      "01000000"
      "00000000"
      "00000000"
      "02000000"
      "08"
      "09"
      "23"
      "c8ca"
      "0000000000000000000000000000"
      "f3e703"
      "000000000000000000000000000000"
      "26"
      "0000000000");
  const std::string delta = bytes_of_hex(
      "544c0103"
      "01000000"
      "02000000"
      "32000000"
      "0000803e"
      "02000000"
      "01"
      "02"
      "00"
      "0100"
      "03000000");
  const Numbers before = {100, -250, 3, 101, -250, 5};
  EXPECT_EQ(proto::encode_key({1, 1, 0, 0}, before), key);
  EXPECT_EQ(proto::encode_delta({1, 2, 50, 0.25f}, Numbers{99, -252, 3, 101, -250, 5}, before), delta);
}

TEST(FrameCodec, WritesTheGoldenFrames) {
  ASSERT_GE(golden_frames().size(), 10u);
  for (const GoldenFrame& golden : golden_frames()) EXPECT_EQ(encoded(golden), golden.bytes) << golden.file;
}

TEST(FrameCodec, ReadsTheGoldenFrames) {
  for (const GoldenFrame& golden : golden_frames()) {
    const auto frame = proto::decode_frame(golden.bytes, golden.before);
    ASSERT_TRUE(frame) << golden.file << ": " << to_string(frame.error());
    expect_same(*frame, golden.frame, golden.file);
  }
}

TEST(FrameCodec, RefusesTheGoldenMisfits) {
  ASSERT_GE(refused_messages("refused_frames").size(), 15u);
  for (const RefusedMessage& refused : refused_messages("refused_frames")) {
    const auto frame = proto::decode_frame(refused.bytes, refused.before);
    ASSERT_FALSE(frame) << refused.why;
    EXPECT_EQ(frame.error().code, refused.code) << refused.why;
  }
}

TEST(FrameCodec, CarriesEveryNumberOfVerticesAroundTheBlockSize) {
  for (int vertices = 0; vertices <= 50; ++vertices) {
    const Numbers before = cloth(vertices, 0), now = cloth(vertices, 7);
    const auto key = proto::decode_frame(proto::encode_key({}, now), {});
    const auto delta = proto::decode_frame(proto::encode_delta({}, now, before), before);
    ASSERT_TRUE(key && delta) << vertices;
    EXPECT_EQ(key->grid, now) << vertices;
    EXPECT_EQ(delta->grid, now) << vertices;
  }
}

TEST(FrameCodec, DifferencesWrapFromOneEndOfTheGridToTheOther) {
  Numbers low(90, -32768), high(90, 32767);
  for (std::size_t i = 0; i < low.size(); i += 2) std::swap(low[i], high[i]);
  const std::string delta = proto::encode_delta({}, high, low);
  EXPECT_LE(delta.size(), 24u + 6 + 6 * 2 * 2);  // ±1 modulo 2¹⁶: two bits a number
  EXPECT_EQ(proto::decode_frame(delta, low)->grid, high);
}

TEST(FrameCodec, AClothAtRestTakesOneByteABlock) {
  const Numbers still = cloth(160, 3);
  EXPECT_EQ(proto::encode_delta({}, still, still).size(), 24u + 3 * 10);
}

TEST(FrameCodec, AClothThatMovesAsOneTakesLittleMore) {
  const Numbers before = cloth(160, 3);
  Numbers now = before;
  for (auto& n : now) n = static_cast<std::int16_t>(n + 1000);
  const std::size_t first_blocks = 3 * 2 * 11;  // 1000 is 11 bits in zigzag; later blocks repeat it
  EXPECT_EQ(proto::encode_delta({}, now, before).size(), 24u + 3 * 10 + first_blocks);
}

TEST(FrameCodec, ReadsMessagesThatStandAtAnyAddress) {
  const std::string key = proto::encode_key({1, 1, 0, 0}, cloth(40, 0));
  for (std::size_t offset = 0; offset < 8; ++offset) {
    const std::string shifted = std::string(offset, '#') + key;
    EXPECT_EQ(proto::decode_frame(std::string_view(shifted).substr(offset), {})->grid, cloth(40, 0));
  }
}

TEST(MessageType, TellsTheThreeMessagesApart) {
  EXPECT_EQ(*proto::message_type(proto::encode_key({}, cloth(4, 0))), proto::MessageType::kKey);
  EXPECT_EQ(*proto::message_type(proto::encode_delta({}, cloth(4, 0), cloth(4, 1))),
            proto::MessageType::kDelta);
  EXPECT_EQ(*proto::message_type(proto::encode_topology(1, {}, {}, {})), proto::MessageType::kTopology);
  EXPECT_EQ(proto::message_type("TL\x01").error().code, "frame.malformed");
}

TEST(FrameGrid, QuantisesToTheNearestPoint) {
  const proto::FrameGrid grid{.origin = {0.3, 1.1, -0.2}, .step = 1e-4};
  std::vector<Vec3> positions;
  for (int i = 0; i < 5000; ++i) {
    positions.push_back({0.3 + 0.000601337 * (i - 2500), 1.1 - 0.00031 * i, -0.2 + 1e-5 * i});
  }
  const auto back = proto::dequantise(proto::quantise(positions, grid), grid);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 off = back[i] - positions[i];
    ASSERT_LE(std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}), 0.05e-3 * (1 + 1e-9)) << i;
  }
}

TEST(FrameGrid, QuantisesBelowTheOriginAsAboveIt) {
  const proto::FrameGrid grid{.origin = {}, .step = 1};
  const std::vector<Vec3> positions = {{-1.4, -1.6, 1.6}, {-0.4, 0.4, 0.6}};
  EXPECT_EQ(proto::quantise(positions, grid), (Numbers{-1, -2, 2, 0, 0, 1}));
}

TEST(FrameGrid, ClampsWhatFliesOffAndPutsNoNumberAtTheOrigin) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<Vec3> positions = {{4, -4, 1e300}, {inf, -inf, std::nan("")}};
  EXPECT_EQ(proto::quantise(positions, proto::FrameGrid{}),
            (Numbers{32767, -32768, 32767, 32767, -32768, 0}));
}

TEST(FrameGrid, IsATenthOfAMillimetreAroundAGarment) {
  const proto::FrameGrid grid = proto::grid_for({-0.4, 0.2, -0.3}, {0.4, 1.6, 0.5});
  EXPECT_DOUBLE_EQ(grid.step, 1e-4);
  EXPECT_DOUBLE_EQ(grid.origin.x, 0);
  EXPECT_DOUBLE_EQ(grid.origin.y, 0.9);
  EXPECT_DOUBLE_EQ(grid.origin.z, 0.1);
}

TEST(FrameGrid, GrowsUntilWideBoundsAndTheirRoomFit) {
  for (const double half : {2.2, 2.4, 5.0, 100.0, 1e5}) {
    const proto::FrameGrid grid = proto::grid_for({-half, 0, 0}, {half, 1, 1});
    EXPECT_GE(32767 * grid.step, half + 1) << half;
    EXPECT_LE(32767 * grid.step, std::max(3.2767, half + 1 + 0.33 + 1e-9)) << half;
  }
}

TEST(FrameGrid, OfNoBoundsIsThePlainOne) {
  EXPECT_DOUBLE_EQ(proto::grid_for({0, std::nan(""), 0}, {1, 1, 1}).step, 1e-4);
}

TEST(FrameReader, FollowsAKeyAndItsDeltas) {
  proto::FrameReader reader(2, 100);
  EXPECT_FALSE(reader.frame());
  ASSERT_TRUE(reader.read(proto::encode_key({2, 10, 500, 1}, cloth(100, 10))));
  for (int t = 11; t < 20; ++t) {
    const proto::FrameHeader header{2, static_cast<std::uint32_t>(t), 50 * t, 0.1f};
    ASSERT_TRUE(reader.read(proto::encode_delta(header, cloth(100, t), cloth(100, t - 1))));
  }
  EXPECT_EQ(reader.frame()->grid, cloth(100, 19));
  EXPECT_EQ(reader.frame()->header.step, 950);
}

TEST(FrameReader, RefusesADeltaAfterAGapAndKeepsWhatItHas) {
  proto::FrameReader reader(1, 20);
  EXPECT_EQ(reader.read(proto::encode_delta({1, 2}, cloth(20, 2), cloth(20, 1))).error().code,
            "frame.wrong_base");
  ASSERT_TRUE(reader.read(proto::encode_key({1, 1}, cloth(20, 1))));
  EXPECT_EQ(reader.read(proto::encode_delta({1, 3}, cloth(20, 3), cloth(20, 2))).error().code,
            "frame.wrong_base");
  EXPECT_EQ(reader.read(proto::encode_delta({1, 1}, cloth(20, 1), cloth(20, 0))).error().code,
            "frame.wrong_base");
  EXPECT_EQ(reader.frame()->grid, cloth(20, 1));
  EXPECT_TRUE(reader.read(proto::encode_delta({1, 2}, cloth(20, 2), cloth(20, 1))));
}

TEST(FrameReader, TakesALaterKeyAfterAGap) {
  proto::FrameReader reader(1, 20);
  ASSERT_TRUE(reader.read(proto::encode_key({1, 1}, cloth(20, 1))));
  ASSERT_TRUE(reader.read(proto::encode_key({1, 9}, cloth(20, 9))));
  EXPECT_TRUE(reader.read(proto::encode_delta({1, 10}, cloth(20, 10), cloth(20, 9))));
}

TEST(FrameReader, RefusesFramesOfAnotherEpochAndOfAnotherGarment) {
  proto::FrameReader reader(4, 20);
  EXPECT_EQ(reader.read(proto::encode_key({3, 1}, cloth(20, 1))).error().code, "frame.wrong_base");
  EXPECT_EQ(reader.read(proto::encode_key({4, 1}, cloth(21, 1))).error().code, "frame.malformed");
  EXPECT_FALSE(reader.frame());
}

}  // namespace
}  // namespace toile
