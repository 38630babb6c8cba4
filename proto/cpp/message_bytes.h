#pragma once
// Little-endian numbers in and out of a message, and the eight bytes that every message begins with.

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "proto/cpp/frame_codec.h"

namespace toile::proto {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they stand in memory");

inline constexpr std::string_view kMessageMagic = "TL";
inline constexpr std::uint8_t kMessageVersion = 1;
inline constexpr std::size_t kPrefixSize = 8;  ///< magic, version, type, epoch

template <typename T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

/// Seven bits a byte, the lowest first; the top bit says that more follow.
void put_varint(std::string& out, std::uint32_t value);
/// A difference of two indices.
void put_difference(std::string& out, std::int32_t difference);
void put_prefix(std::string& out, MessageType type, std::uint32_t epoch);

/// Reads on from the front. Once something was missing everything reads as zero and ok() stays false.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  bool ok() const { return ok_; }
  std::size_t left() const { return rest_.size(); }

  template <typename T>
  T take() {
    T value{};
    const std::string_view bytes = take_bytes(sizeof(T));
    if (ok_) std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }
  std::string_view take_bytes(std::size_t count);
  std::uint32_t take_varint();
  std::int32_t take_difference();

 private:
  std::string_view rest_;
  bool ok_ = true;
};

Error malformed(std::string message);

}  // namespace toile::proto
