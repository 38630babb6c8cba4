#include "core/image/exif.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace toile::image {
namespace {

constexpr unsigned char kHead[] = {'E', 'x', 'i', 'f', 0, 0};
constexpr std::uint32_t kOrientationTag = 0x0112, kShort = 3;

/// Numbers of a TIFF block, each only where it lies within.
class TiffBlock {
 public:
  TiffBlock(std::span<const unsigned char> bytes, bool little) : bytes_(bytes), little_(little) {}

  std::optional<std::uint32_t> number(std::size_t at, int size) const {
    if (at > bytes_.size() || bytes_.size() - at < static_cast<std::size_t>(size)) return std::nullopt;
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) value = value << 8 | bytes_[at + (little_ ? size - 1 - i : i)];
    return value;
  }

 private:
  std::span<const unsigned char> bytes_;
  bool little_;
};

}  // namespace

int exif_orientation(std::span<const unsigned char> segment) {
  if (segment.size() < sizeof kHead + 8 || !std::equal(std::begin(kHead), std::end(kHead), segment.begin()))
    return 1;
  const auto bytes = segment.subspan(sizeof kHead);
  if (bytes[0] != bytes[1] || (bytes[0] != 'I' && bytes[0] != 'M')) return 1;
  // "II" is little-endian, "MM" big-endian; at 4 stands where the list of tags begins, at 12 bytes each:
  // number, type, count, value.
  const TiffBlock tiff(bytes, bytes[0] == 'I');
  const std::size_t list = tiff.number(4, 4).value_or(0);
  const std::uint32_t count = tiff.number(list, 2).value_or(0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t entry = list + 2 + std::size_t{12} * i;
    const auto tag = tiff.number(entry, 2);
    if (!tag) return 1;
    if (*tag != kOrientationTag || tiff.number(entry + 2, 2) != kShort) continue;
    const std::uint32_t value = tiff.number(entry + 8, 2).value_or(1);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

}  // namespace toile::image
