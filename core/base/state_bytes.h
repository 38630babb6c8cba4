#pragma once
// Plain values as bytes, little endian, and back. What is read may be anything: a reader never goes past its
// end, never takes more memory than its bytes can fill, and remembers that something was missing.

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/types.h"

namespace toile {

class StateWriter {
 public:
  template <typename T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void value(T v) {
    auto bits = static_cast<std::uint64_t>(v);
    for (std::size_t k = 0; k < sizeof(T); ++k, bits >>= 8) bytes_.push_back(static_cast<char>(bits & 0xff));
  }
  void value(double v) { value(std::bit_cast<std::uint64_t>(v)); }
  void value(float v) { value(std::bit_cast<std::uint32_t>(v)); }
  void value(Vec2 p) {
    value(p.x);
    value(p.y);
  }
  void value(Vec3 p) {
    value(p.x);
    value(p.y);
    value(p.z);
  }
  void value(std::string_view text) {
    size(text.size());
    bytes_.append(text);
  }
  void value(const std::string& text) { value(std::string_view(text)); }
  /// Eight to a byte.
  void value(const std::vector<bool>& bits) {
    size(bits.size());
    for (std::size_t i = 0; i < bits.size(); i += 8) {
      std::uint8_t byte = 0;
      for (std::size_t k = i; k < bits.size() && k < i + 8; ++k) {
        byte = static_cast<std::uint8_t>(byte | bits[k] << (k - i));
      }
      value(byte);
    }
  }
  template <typename T>
  void value(const std::vector<T>& list) {
    size(list.size());
    for (const T& v : list) value(v);
  }
  /// Things of several values each, by what each(thing) writes. The second argument is the reader's.
  template <typename T, typename Each>
  void list(std::vector<T>& things, std::size_t /*least_bytes*/, Each&& each) {
    size(things.size());
    for (T& thing : things) each(thing);
  }
  /// How many things follow.
  void size(std::size_t n) { value(static_cast<std::uint32_t>(n)); }
  /// Without its length.
  void raw(std::string_view bytes) { bytes_.append(bytes); }

  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class StateReader {
 public:
  explicit StateReader(std::string_view bytes) : rest_(bytes) {}

  /// False once anything was missing; what was read since then is zero or empty.
  bool ok() const { return ok_; }
  bool at_end() const { return rest_.empty(); }
  /// What was read can be no value of its field: ok() is false from now on.
  void refuse() { ok_ = false; }

  template <typename T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void value(T& v) {
    std::uint64_t bits = 0;
    const std::string_view bytes = raw(sizeof(T));
    for (std::size_t k = 0; k < bytes.size(); ++k) {
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[k])) << (8 * k);
    }
    v = static_cast<T>(bits);
  }
  void value(double& v) {
    std::uint64_t bits = 0;
    value(bits);
    v = std::bit_cast<double>(bits);
  }
  void value(float& v) {
    std::uint32_t bits = 0;
    value(bits);
    v = std::bit_cast<float>(bits);
  }
  void value(Vec2& p) {
    value(p.x);
    value(p.y);
  }
  void value(Vec3& p) {
    value(p.x);
    value(p.y);
    value(p.z);
  }
  void value(Tri& t) {
    for (Index& v : t) value(v);
  }
  void value(std::string& text) { text = raw(count(1)); }
  void value(std::vector<bool>& bits) {
    std::uint32_t n = 0;
    value(n);
    const std::string_view bytes = raw((std::size_t{n} + 7) / 8);
    bits.assign(ok_ ? n : 0, false);
    for (std::size_t i = 0; i < bits.size(); ++i) {
      bits[i] = static_cast<unsigned char>(bytes[i / 8]) >> (i % 8) & 1;
    }
  }
  void value(std::vector<double>& list) { values(list, sizeof(double)); }
  void value(std::vector<float>& list) { values(list, sizeof(float)); }
  void value(std::vector<Vec2>& list) { values(list, 2 * sizeof(double)); }
  void value(std::vector<Vec3>& list) { values(list, 3 * sizeof(double)); }
  void value(std::vector<Index>& list) { values(list, sizeof(Index)); }
  void value(std::vector<Tri>& list) { values(list, sizeof(Tri)); }
  /// Things of several values each, `least_bytes` or more altogether, by what each(thing) reads.
  template <typename T, typename Each>
  void list(std::vector<T>& things, std::size_t least_bytes, Each&& each) {
    things.assign(count(least_bytes), T{});
    for (T& thing : things) each(thing);
  }
  /// How many things of `each` bytes at least follow; 0, and not ok(), where there is no room for them.
  std::size_t count(std::size_t each) {
    std::uint32_t n = 0;
    value(n);
    if (n > rest_.size() / each) ok_ = false;
    return ok_ ? n : 0;
  }
  /// The next `n` bytes; none when there are fewer.
  std::string_view raw(std::size_t n) {
    if (!ok_ || n > rest_.size()) {
      ok_ = false;
      return std::string_view();
    }
    const std::string_view bytes = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return bytes;
  }

 private:
  template <typename T>
  void values(std::vector<T>& list, std::size_t each) {
    list.resize(count(each));
    for (T& v : list) value(v);
  }

  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace toile
