#include "proto/cpp/bit_pack.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <utility>

namespace toile::proto {
namespace {

static_assert(std::endian::native == std::endian::little, "words are copied as they stand in memory");

// One function a width: with the width known, every shift is a constant and the loops unroll. Eight numbers
// are `width` whole bytes, held in two words of 64 bits.

template <int W>
void pack_eight(const std::uint16_t* v, char* out) {
  std::uint64_t low = 0, high = 0;
  for (int i = 0; i < 4; ++i) {
    low |= static_cast<std::uint64_t>(v[i]) << (W * i);
    high |= static_cast<std::uint64_t>(v[i + 4]) << (W * i);
  }
  if constexpr (W <= 8) {
    low |= high << (4 * W);
    std::memcpy(out, &low, W);
  } else {
    if constexpr (W < 16) {
      low |= high << (4 * W);
      high >>= 64 - 4 * W;
    }
    std::memcpy(out, &low, 8);
    std::memcpy(out + 8, &high, W - 8);
  }
}

template <int W>
void unpack_eight(const char* in, std::uint16_t* v) {
  std::uint64_t low = 0, high = 0;
  std::memcpy(&low, in, std::min(W, 8));
  if constexpr (W > 8) std::memcpy(&high, in + 8, W - 8);
  if constexpr (W <= 8) {
    high = low >> (4 * W);
  } else if constexpr (W < 16) {
    high = (high << (64 - 4 * W)) | (low >> (4 * W));
  }
  constexpr std::uint64_t mask = (std::uint64_t{1} << W) - 1;
  for (int i = 0; i < 4; ++i) {
    v[i] = static_cast<std::uint16_t>((low >> (W * i)) & mask);
    v[i + 4] = static_cast<std::uint16_t>((high >> (W * i)) & mask);
  }
}

template <int W>
void pack(const std::uint16_t* values, char* out) {
  if constexpr (W > 0) {
    pack_eight<W>(values, out);
    pack_eight<W>(values + 8, out + W);
  }
}

template <int W>
void unpack(const char* in, std::uint16_t* values) {
  if constexpr (W == 0) {
    std::memset(values, 0, kBlock * sizeof(std::uint16_t));
  } else {
    unpack_eight<W>(in, values);
    unpack_eight<W>(in + W, values + 8);
  }
}

using Pack = void (*)(const std::uint16_t*, char*);
using Unpack = void (*)(const char*, std::uint16_t*);

template <int... W>
constexpr std::array<Pack, sizeof...(W)> packs(std::integer_sequence<int, W...>) {
  return {pack<W>...};
}
template <int... W>
constexpr std::array<Unpack, sizeof...(W)> unpacks(std::integer_sequence<int, W...>) {
  return {unpack<W>...};
}
using Widths = std::make_integer_sequence<int, kMaxWidth + 1>;
constexpr auto kPack = packs(Widths{});
constexpr auto kUnpack = unpacks(Widths{});

}  // namespace

void pack_block(int width, const std::uint16_t* values, char* out) {
  kPack[static_cast<std::size_t>(width)](values, out);
}

void unpack_block(int width, const char* in, std::uint16_t* values) {
  kUnpack[static_cast<std::size_t>(width)](in, values);
}

}  // namespace toile::proto
