#include "core/pattern/dxf_groups.h"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace toile {
namespace {

constexpr std::size_t kLongestLine = 4096;  // the format allows 2049 characters
constexpr std::size_t kLongestText = 120;   // characters kept of a name

std::string_view trimmed(std::string_view s) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!s.empty() && blank(s.front())) s.remove_prefix(1);
  while (!s.empty() && blank(s.back())) s.remove_suffix(1);
  return s;
}

}  // namespace

std::string line_text(int line) { return "line " + std::to_string(line); }

std::optional<std::string_view> DxfGroupReader::next_line() {
  if (at_ >= text_.size()) return std::nullopt;
  ++line_;
  const std::string_view rest = text_.substr(at_, kLongestLine + 1);
  const std::size_t end = rest.find_first_of("\r\n");
  if (end == std::string_view::npos && rest.size() > kLongestLine) {
    error_ = Error{"dxf.bad_group_code", "The line is too long for a DXF file.", line_text(line_)};
    return std::nullopt;
  }
  const std::string_view line = rest.substr(0, end);
  at_ += line.size();
  if (at_ < text_.size()) at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
  return trimmed(line);
}

std::optional<DxfGroup> DxfGroupReader::next() {
  if (error_) return std::nullopt;
  const std::optional<std::string_view> code = next_line();
  if (!code) return std::nullopt;
  int number = 0;
  const auto [end, status] = std::from_chars(code->data(), code->data() + code->size(), number);
  if (status != std::errc() || end != code->data() + code->size()) {
    // A last line without a value is where a cut file ends; blank lines at the end are harmless.
    if (code->empty() && text_.find_first_not_of(" \t\r\n", at_) == std::string_view::npos)
      return std::nullopt;
    error_ = Error{
        "dxf.bad_group_code",
        "A group code is expected here, a whole number, and not '" + clean_text(code->substr(0, 40)) + "'.",
        line_text(line_)};
    return std::nullopt;
  }
  const std::optional<std::string_view> value = next_line();
  if (value) return DxfGroup{number, *value, line_};
  if (!error_)
    error_ = Error{"dxf.truncated",
                   "The file ends after group code " + std::to_string(number) +
                       ", without its value: it is cut off. Get a whole copy.",
                   "last good " + line_text(line_ - 1)};
  return std::nullopt;
}

std::optional<double> number_of(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

namespace {

void append_utf8(std::string& out, std::uint32_t c) {
  if (c < 0x80) {
    out += char(c);
  } else if (c < 0x800) {
    out += char(0xC0 | (c >> 6)), out += char(0x80 | (c & 0x3F));
  } else {
    out += char(0xE0 | (c >> 12)), out += char(0x80 | ((c >> 6) & 0x3F)), out += char(0x80 | (c & 0x3F));
  }
}

/// Length in bytes of the well-formed UTF-8 sequence at the start of s, 0 if it is none.
std::size_t sequence_length(std::string_view s) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  const unsigned char lead = byte(0);
  const std::size_t n = lead < 0x80                   ? 1
                        : lead >= 0xC2 && lead < 0xE0 ? 2
                        : lead >= 0xE0 && lead < 0xF0 ? 3
                        : lead >= 0xF0 && lead < 0xF5 ? 4
                                                      : 0;
  if (n == 0 || s.size() < n) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Overlong forms, surrogates and values past the last plane.
  if (lead == 0xE0 && byte(1) < 0xA0) return 0;
  if (lead == 0xED && byte(1) > 0x9F) return 0;
  if (lead == 0xF0 && byte(1) < 0x90) return 0;
  if (lead == 0xF4 && byte(1) > 0x8F) return 0;
  return n;
}

/// The character of an escape \U+XXXX at the start of s, if it is one that stands for itself.
std::optional<std::uint32_t> escaped_character(std::string_view s) {
  if (s.size() < 7 || s.substr(0, 3) != "\\U+") return std::nullopt;
  std::uint32_t c = 0;
  const auto [end, status] = std::from_chars(s.data() + 3, s.data() + 7, c, 16);
  if (status != std::errc() || end != s.data() + 7 || c < 0x20 || (c >= 0xD800 && c < 0xE000))
    return std::nullopt;
  return c;
}

}  // namespace

std::string clean_text(std::string_view s) {
  std::string out;
  for (std::size_t characters = 0; !s.empty() && characters < kLongestText; ++characters) {
    if (const auto c = escaped_character(s)) {
      append_utf8(out, *c);
      s.remove_prefix(7);
      continue;
    }
    const std::size_t n = sequence_length(s);
    if (n == 0) append_utf8(out, static_cast<unsigned char>(s[0]));
    if (n > 1 || (n == 1 && s[0] >= 0x20 && s[0] != 0x7F)) out += s.substr(0, n);
    s.remove_prefix(n == 0 ? 1 : n);
  }
  return std::string(trimmed(out));
}

}  // namespace toile
