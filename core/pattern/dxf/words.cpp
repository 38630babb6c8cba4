#include "core/pattern/dxf/words.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "core/base/text.h"

namespace toile::dxf {
namespace {

constexpr std::size_t kLongestText = 120;  // characters kept of a name
constexpr std::size_t kLongestKey = 24;

void append_utf8(std::string& out, std::uint32_t c) {
  if (c < 0x80) {
    out += char(c);
  } else if (c < 0x800) {
    out += char(0xC0 | (c >> 6));
    out += char(0x80 | (c & 0x3F));
  } else {
    out += char(0xE0 | (c >> 12));
    out += char(0x80 | ((c >> 6) & 0x3F));
    out += char(0x80 | (c & 0x3F));
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

bool is_utf8(std::string_view s) {
  while (!s.empty()) {
    const std::size_t n = sequence_length(s);
    if (n == 0) return false;
    s.remove_prefix(n);
  }
  return true;
}

/// Whether a text that is UTF-8 by its form holds letters that nobody writes patterns with (rare extensions
/// of Latin, Armenian): many pairs of GB 2312 have that form.
bool has_rare_letters(std::string_view s) {
  for (std::size_t i = 0; i < s.size(); i += std::max<std::size_t>(1, sequence_length(s.substr(i)))) {
    const unsigned char lead = static_cast<unsigned char>(s[i]);
    if ((lead >= 0xC6 && lead <= 0xCD) || (lead >= 0xD2 && lead <= 0xD6)) return true;
  }
  return false;
}

/// Whether all high bytes come in pairs of GB 2312: letters of Latin 1 seldom stand two by two.
bool in_pairs(std::string_view s) {
  const auto high = [&](std::size_t i) { return i < s.size() && static_cast<unsigned char>(s[i]) >= 0xA1; };
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (static_cast<unsigned char>(s[i]) < 0x80) continue;
    const unsigned char lead = static_cast<unsigned char>(s[i]);
    const bool chinese = (lead >= 0xA1 && lead <= 0xA9) || (lead >= 0xB0 && lead <= 0xF7);
    if (!chinese || !high(i + 1)) return false;
    ++i;
  }
  return true;
}

/// The text from GBK, nothing when it is none.
std::optional<std::string> from_gbk(std::string_view s) {
  const iconv_t converter = iconv_open("UTF-8", "GBK");
  if (converter == iconv_t(-1)) return std::nullopt;  // NOLINT(performance-no-int-to-ptr): iconv's own word
  std::string in(s), out(s.size() * 2 + 8, '\0');
  char *from = in.data(), *to = out.data();
  std::size_t left = in.size(), room = out.size();
  const bool whole = iconv(converter, &from, &left, &to, &room) != std::size_t(-1) && left == 0;
  iconv_close(converter);
  if (!whole) return std::nullopt;
  out.resize(out.size() - room);
  return out;
}

/// The character of an escape \U+XXXX at the start of s, if it is one that stands for itself.
std::optional<std::uint32_t> escaped_character(std::string_view s) {
  if (s.size() < 7 || s.substr(0, 3) != "\\U+") return std::nullopt;
  const auto c = number_in<std::uint32_t>(s.substr(3, 4), 16);
  if (!c || *c < 0x20 || (*c >= 0xD800 && *c < 0xE000)) return std::nullopt;
  return c;
}

/// Length and character of %%d (degree), %%p (plus-minus), %%c (diameter) at the start of s.
std::optional<std::uint32_t> percent_character(std::string_view s) {
  if (s.size() < 3 || s.substr(0, 2) != "%%") return std::nullopt;
  const char c = s[2];
  if (c == 'd' || c == 'D') return 0xB0;
  if (c == 'p' || c == 'P') return 0xB1;
  if (c == 'c' || c == 'C') return 0x2300;
  return std::nullopt;
}

}  // namespace

DxfEncoding encoding_of(std::string_view code_page) {
  const std::string name = lower_case(code_page);
  if (name.find("936") != std::string::npos || name.find("gb") == 0) return DxfEncoding::kGbk;
  // Many programs declare 1252 whatever they write: that says nothing.
  if (name.find("850") != std::string::npos || name.find("8859") != std::string::npos)
    return DxfEncoding::kLatin;
  return DxfEncoding::kUnknown;
}

std::string clean_text(std::string_view s, DxfEncoding encoding) {
  std::optional<std::string> chinese;
  const bool guess = encoding == DxfEncoding::kUnknown && in_pairs(s) && (!is_utf8(s) || has_rare_letters(s));
  if (guess || (encoding == DxfEncoding::kGbk && !is_utf8(s))) chinese = from_gbk(s);
  if (chinese) s = *chinese;
  std::string out;
  for (std::size_t characters = 0; !s.empty() && characters < kLongestText; ++characters) {
    if (const auto c = escaped_character(s)) {
      append_utf8(out, *c);
      s.remove_prefix(7);
      continue;
    }
    if (const auto c = percent_character(s)) {
      append_utf8(out, *c);
      s.remove_prefix(3);
      continue;
    }
    const std::size_t n = sequence_length(s);
    if (n == 0) append_utf8(out, static_cast<unsigned char>(s[0]));
    if (n > 1 || (n == 1 && s[0] >= 0x20 && s[0] != 0x7F)) out += s.substr(0, n);
    s.remove_prefix(n == 0 ? 1 : n);
  }
  return std::string(trimmed(out));
}

std::string plain_text(std::string_view s) {
  std::string out;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s[i] == '{' || s[i] == '}') continue;
    if (s[i] != '\\' || i + 1 >= s.size()) {
      out += s[i];
      continue;
    }
    const char code = s[++i];
    if (code == 'P' || code == '~') out += ' ';
    if (code == '\\' || code == '{' || code == '}') out += code;
    if (code == 'U') out += "\\U";
    // Codes with an argument run to a semicolon.
    if (std::string_view("ACFHQTWSfp").find(code) != std::string_view::npos)
      while (i + 1 < s.size() && s[i] != ';') ++i;
  }
  return out;
}

bool is_lost(std::string_view text) {
  return text.find('?') != std::string_view::npos && text.find_first_not_of("? _-") == std::string_view::npos;
}

std::optional<DxfStatement> statement_of(const std::string& text) {
  std::size_t colon = text.find(':');
  std::size_t width = 1;
  constexpr std::string_view kWideColon = "\xEF\xBC\x9A";  // of Chinese and Japanese keyboards
  if (const std::size_t wide = text.find(kWideColon); wide < colon) {
    colon = wide;
    width = kWideColon.size();
  }
  if (colon == std::string::npos || colon == 0 || colon > kLongestKey) return std::nullopt;
  DxfStatement statement;
  for (char c : lower_case(std::string_view(text).substr(0, colon))) {
    const bool blank = c == ' ' || c == '_';
    if (!blank) statement.key += c;
    if (blank && !statement.key.empty() && statement.key.back() != ' ') statement.key += ' ';
  }
  while (!statement.key.empty() && statement.key.back() == ' ') statement.key.pop_back();
  statement.value = trimmed(std::string_view(text).substr(colon + width));
  if (statement.key.empty()) return std::nullopt;
  return statement;
}

std::optional<DxfQuantity> quantity_of(std::string_view value) {
  constexpr int kMost = 1000;
  std::array<int, 2> counts{};
  bool told_apart = false;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    value = trimmed(value);
    const auto [end, status] = std::from_chars(value.data(), value.data() + value.size(), counts[i]);
    if (i == 1 && value.empty()) break;  // "2,"
    told_apart = i == 1;
    if (status != std::errc() || counts[i] < 0 || counts[i] > kMost) return std::nullopt;
    value = trimmed(value.substr(static_cast<std::size_t>(end - value.data())));
    // "2.0" and "2 pcs" are two.
    if (!value.empty() && value.front() == '.') value = value.substr(std::min(value.size(), std::size_t{2}));
    if (value.empty() || (value.front() != ',' && value.front() != ';' && value.front() != '/')) break;
    value.remove_prefix(1);
  }
  if (!told_apart && lower_case(value).starts_with("pair")) return DxfQuantity{counts[0], counts[0], true};
  return DxfQuantity{counts[0], counts[1], told_apart};
}

}  // namespace toile::dxf
