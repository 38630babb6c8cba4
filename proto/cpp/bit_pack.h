#pragma once
// Sixteen numbers of one bit width, packed without gaps: the smallest brick of a frame (proto/frames.md).

#include <cstdint>

namespace toile::proto {

inline constexpr int kBlock = 16;     ///< numbers a block
inline constexpr int kMaxWidth = 16;  ///< bits a number

/// Bytes of a block of numbers of `width` bits.
constexpr int packed_size(int width) { return 2 * width; }

/// Signed to unsigned so that small ones of either sign stay small: 0, −1, 1, −2 … become 0, 1, 2, 3 …
constexpr std::uint16_t zigzag(std::uint16_t difference) {
  return static_cast<std::uint16_t>((difference << 1) ^ -(difference >> 15));
}
constexpr std::uint16_t unzigzag(std::uint16_t code) {
  return static_cast<std::uint16_t>((code >> 1) ^ -(code & 1));
}

/// Writes packed_size(width) bytes at `out`. REQUIRES 0 <= width <= kMaxWidth and every value below 2^width.
void pack_block(int width, const std::uint16_t* values, char* out);

/// Reads packed_size(width) bytes at `in`. REQUIRES 0 <= width <= kMaxWidth.
void unpack_block(int width, const char* in, std::uint16_t* values);

}  // namespace toile::proto
