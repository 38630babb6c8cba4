#pragma once
// The bytes of a DXF file, one after the other.

#include <cstddef>
#include <istream>
#include <string_view>
#include <vector>

namespace toile::dxf {

/// Reads a stream with one buffer of 64 KiB.
class DxfByteSource {
 public:
  /// Reads no more than `max_bytes` of the stream, which must outlive the source.
  DxfByteSource(std::istream& in, std::size_t max_bytes);

  /// The first bytes (up to 1 KiB), to be asked before any is taken.
  std::string_view beginning() const { return std::string_view(buffer_.data() + at_, shown_); }
  /// The next byte, without taking it; -1 at the end.
  int peek();
  /// The next byte; -1 at the end.
  int take();
  /// Whether the stream has more than max_bytes: it ends there.
  bool too_long() const { return too_long_; }
  std::size_t most() const { return max_bytes_; }

 private:
  bool fill();

  std::istream& in_;
  std::vector<char> buffer_;
  std::size_t at_ = 0, end_ = 0, shown_ = 0, bytes_ = 0, max_bytes_;
  bool too_long_ = false;
};

}  // namespace toile::dxf
