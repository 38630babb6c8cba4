#include "core/pattern/dxf/byte_source.h"

#include <algorithm>

namespace toile::dxf {
namespace {
constexpr std::size_t kBuffer = std::size_t{64} << 10;
constexpr std::size_t kShown = 1024;
}  // namespace

DxfByteSource::DxfByteSource(std::istream& in, std::size_t max_bytes)
    : in_(in), buffer_(kBuffer), max_bytes_(max_bytes) {
  fill();
  constexpr std::string_view kMark = "\xEF\xBB\xBF";  // byte order mark
  if (std::string_view(buffer_.data(), end_).starts_with(kMark)) at_ = kMark.size();
  shown_ = std::min(kShown, end_ - at_);
}

bool DxfByteSource::fill() {
  if (too_long_) return false;
  in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  at_ = 0;
  end_ = static_cast<std::size_t>(in_.gcount());
  bytes_ += end_;
  too_long_ = bytes_ > max_bytes_;
  if (too_long_) end_ = 0;
  return end_ > 0;
}

int DxfByteSource::peek() {
  if (at_ == end_ && !fill()) return -1;
  return static_cast<unsigned char>(buffer_[at_]);
}

int DxfByteSource::take() {
  const int byte = peek();
  if (byte >= 0) ++at_;
  return byte;
}

}  // namespace toile::dxf
