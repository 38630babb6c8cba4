#include "core/pattern/dxf/binary_groups.h"

#include <bit>
#include <cstdint>

#include "core/base/text.h"
#include "core/pattern/dxf/group_codes.h"

namespace toile::dxf {
namespace {

constexpr std::string_view kSentinel("AutoCAD Binary DXF\r\n\x1A\0", 22);
constexpr std::size_t kLongestValue = 4096;  // bytes; what is longer ends no text of a DXF file

/// An unsigned number of so many bytes, the least first; nothing at the end of the file.
std::optional<std::uint64_t> number(DxfByteSource& bytes, int count) {
  std::uint64_t value = 0;
  for (int i = 0; i < count; ++i) {
    const int byte = bytes.take();
    if (byte < 0) return std::nullopt;
    value |= std::uint64_t(byte) << (8 * i);
  }
  return value;
}

std::optional<int> next_code(DxfByteSource& bytes, DxfCodeWidth width) {
  constexpr std::uint64_t kTwoFollow = 255;
  std::optional<std::uint64_t> code = number(bytes, width == DxfCodeWidth::kOneByte ? 1 : 2);
  if (code == kTwoFollow && width == DxfCodeWidth::kOneByte) code = number(bytes, 2);
  if (!code) return std::nullopt;
  return static_cast<std::int16_t>(*code);
}

std::optional<std::string> text(DxfByteSource& bytes) {
  std::string out;
  for (int byte = bytes.take(); byte != 0; byte = bytes.take()) {
    if (byte < 0 || out.size() == kLongestValue) return std::nullopt;
    out += static_cast<char>(byte);
  }
  return out;
}

std::optional<std::string> chunk(DxfByteSource& bytes) {
  const std::optional<std::uint64_t> count = number(bytes, 1);
  for (std::uint64_t i = 0; count && i < *count; ++i)
    if (bytes.take() < 0) return std::nullopt;
  return count ? std::optional(std::string()) : std::nullopt;
}

template <typename Whole>
std::optional<std::string> whole(DxfByteSource& bytes) {
  const std::optional<std::uint64_t> value = number(bytes, int(sizeof(Whole)));
  return value ? std::optional(std::to_string(static_cast<Whole>(*value))) : std::nullopt;
}

std::optional<std::string> real(DxfByteSource& bytes) {
  const std::optional<std::uint64_t> value = number(bytes, 8);
  return value ? std::optional(number_text(std::bit_cast<double>(*value))) : std::nullopt;
}

std::optional<std::string> value_of(DxfByteSource& bytes, DxfValueKind kind) {
  switch (kind) {
    case DxfValueKind::kReal:
      return real(bytes);
    case DxfValueKind::kBoolean:
      return whole<std::int8_t>(bytes);
    case DxfValueKind::kShort:
      return whole<std::int16_t>(bytes);
    case DxfValueKind::kInteger:
      return whole<std::int32_t>(bytes);
    case DxfValueKind::kLong:
      return whole<std::int64_t>(bytes);
    case DxfValueKind::kChunk:
      return chunk(bytes);
    default:
      return text(bytes);
  }
}

}  // namespace

std::optional<DxfCodeWidth> binary_width(std::string_view beginning) {
  if (!beginning.starts_with(kSentinel)) return std::nullopt;
  const std::string_view first = beginning.substr(kSentinel.size());
  // The first group is 0 SECTION or 999 and a comment: in two bytes, the code's second one is 0 or 3.
  const bool two = first.size() > 1 && (first[1] == '\0' || (first[0] == '\xE7' && first[1] == '\x03'));
  return two ? DxfCodeWidth::kTwoBytes : DxfCodeWidth::kOneByte;
}

void pass_sentinel(DxfByteSource& bytes) {
  for (std::size_t i = 0; i < kSentinel.size(); ++i) bytes.take();
}

DxfBinaryGroup next_binary_group(DxfByteSource& bytes, DxfCodeWidth width) {
  using End = DxfBinaryGroup::End;
  if (bytes.peek() < 0) return {End::kAtOnce, 0, {}};
  const std::optional<int> code = next_code(bytes, width);
  if (!code) return {End::kWithin, 0, {}};
  const DxfValueKind kind = value_kind_of(*code);
  if (kind == DxfValueKind::kUnknown) return {End::kNoCode, *code, {}};
  std::optional<std::string> value = value_of(bytes, kind);
  if (!value) return {bytes.peek() < 0 ? End::kWithin : End::kNoCode, *code, {}};
  return {End::kNone, *code, *std::move(value)};
}

}  // namespace toile::dxf
