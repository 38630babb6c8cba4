#include "proto/cpp/bit_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace toile {
namespace {

using Block = std::array<std::uint16_t, proto::kBlock>;

/// Sixteen numbers of at most `width` bits, the widest among them.
Block block_of(int width) {
  Block block{};
  const unsigned top = (1u << width) - 1;
  for (unsigned i = 0; i < block.size(); ++i) {
    block[i] = static_cast<std::uint16_t>(i % 5 == 0 ? top : (i * 40503u + 77u) & top);
  }
  return block;
}

/// One bit after the other, the lowest first: what packing means.
std::string packed_slowly(int width, const Block& block) {
  std::string bytes(static_cast<std::size_t>(proto::packed_size(width)), '\0');
  for (std::size_t i = 0; i < block.size(); ++i) {
    for (int b = 0; b < width; ++b) {
      const std::size_t bit = i * static_cast<std::size_t>(width) + static_cast<std::size_t>(b);
      if ((block[i] >> b) & 1) bytes[bit / 8] = static_cast<char>(bytes[bit / 8] | (1 << (bit % 8)));
    }
  }
  return bytes;
}

TEST(BitPack, PutsTheBitsOfEveryWidthOneAfterTheOther) {
  for (int width = 0; width <= proto::kMaxWidth; ++width) {
    const Block block = block_of(width);
    std::string bytes(static_cast<std::size_t>(proto::packed_size(width)), '?');
    proto::pack_block(width, block.data(), bytes.data());
    EXPECT_EQ(bytes, packed_slowly(width, block)) << width;
  }
}

TEST(BitPack, UnpacksWhatItPackedFromExactlyThoseBytes) {
  for (int width = 0; width <= proto::kMaxWidth; ++width) {
    const Block block = block_of(width);
    std::vector<char> bytes(
        static_cast<std::size_t>(proto::packed_size(width)));  // a byte more would be seen by ASan
    proto::pack_block(width, block.data(), bytes.data());
    Block back;
    back.fill(0xffff);
    proto::unpack_block(width, bytes.data(), back.data());
    EXPECT_EQ(back, block) << width;
  }
}

TEST(BitPack, ZigzagKeepsSmallNumbersOfEitherSignSmall) {
  EXPECT_EQ(proto::zigzag(0), 0);
  EXPECT_EQ(proto::zigzag(0xffff), 1);
  EXPECT_EQ(proto::zigzag(1), 2);
  EXPECT_EQ(proto::zigzag(0x7fff), 0xfffe);
  EXPECT_EQ(proto::zigzag(0x8000), 0xffff);
}

TEST(BitPack, ZigzagCanBeUndoneForEveryNumber) {
  for (int n = 0; n < 65536; ++n) {
    const auto number = static_cast<std::uint16_t>(n);
    ASSERT_EQ(proto::unzigzag(proto::zigzag(number)), number);
  }
}

}  // namespace
}  // namespace toile
