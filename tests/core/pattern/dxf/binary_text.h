#pragma once
// DXF texts in the binary form, after the DXF reference ("Binary DXF files", "Group code value types").

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace toile::dxf_text {

inline void append_bytes(std::string& out, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) out += static_cast<char>(value >> (8 * i) & 0xFF);
}

inline bool is_within(int code, int first, int last) { return code >= first && code <= last; }

inline void append_value(std::string& out, int code, const std::string& value) {
  const bool real = is_within(code, 10, 59) || is_within(code, 110, 149) || is_within(code, 210, 239) ||
                    is_within(code, 1010, 1059);
  const bool two = is_within(code, 60, 79) || is_within(code, 170, 179) || is_within(code, 270, 289) ||
                   is_within(code, 370, 389) || is_within(code, 1060, 1070);
  const bool four = is_within(code, 90, 99) || is_within(code, 420, 429) || code == 1071;
  if (real)
    append_bytes(out, std::bit_cast<std::uint64_t>(std::strtod(value.c_str(), nullptr)), 8);
  else if (two || four)
    append_bytes(out, static_cast<std::uint64_t>(std::strtoll(value.c_str(), nullptr, 10)), two ? 2 : 4);
  else if (is_within(code, 290, 299))
    out += static_cast<char>(value == "1");
  else if (is_within(code, 310, 319) || code == 1004)
    out += static_cast<char>(value.size() / 2) + std::string(value.size() / 2, '\x5A');
  else
    out += value + '\0';
}

/// The text's groups as binary files of R12 (codes of one byte) or of later releases (of two) hold them.
inline std::string as_binary(const std::string& text, bool two_bytes) {
  std::string out("AutoCAD Binary DXF\r\n\x1A\0", 22);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at), last = text.find('\n', end + 1);
    const int code = std::atoi(text.substr(at, end - at).c_str());
    if (two_bytes || code < 255) append_bytes(out, static_cast<std::uint64_t>(code), two_bytes ? 2 : 1);
    if (!two_bytes && code >= 255) {
      out += '\xFF';
      append_bytes(out, static_cast<std::uint64_t>(code), 2);
    }
    append_value(out, code, text.substr(end + 1, last - end - 1));
    at = last + 1;
  }
  return out;
}

}  // namespace toile::dxf_text
