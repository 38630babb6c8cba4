#include "core/pattern/dxf/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "core/base/latin_letters.h"
#include "core/base/text.h"
#include "core/pattern/dxf/cut_words.h"
#include "core/pattern/dxf/statement_keys.h"

namespace toile::dxf {
namespace {

constexpr std::size_t kLongestName = 120;  // characters kept of a name
constexpr std::size_t kLongestKey = 48;    // bytes: letters of other scripts take two or three

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

std::string clean_text(std::string_view text, DxfEncoding encoding) {
  const std::string whole = utf8_of(text, encoding);
  std::string_view s = whole;
  std::string out;
  for (std::size_t characters = 0; !s.empty() && characters < kLongestName; ++characters) {
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
    const std::size_t n = std::max<std::size_t>(1, utf8_length(s));
    if (n > 1 || (s[0] >= 0x20 && s[0] != 0x7F)) out += s.substr(0, n);
    s.remove_prefix(n);
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

bool is_listed(std::string_view list, std::string_view word) {
  return !word.empty() && list.find(";" + std::string(word) + ";") != std::string_view::npos;
}

bool is_lost(std::string_view text) {
  return text.find('?') != std::string_view::npos && text.find_first_not_of("? _-") == std::string_view::npos;
}

namespace {

/// "CORTAR: 2 TELA" counts pieces, "KROJ: SLIM" or "COUPE: 38" tells how they are cut or their size.
bool orders_cutting(const DxfStatement& statement) {
  constexpr int kMost = 12;  // of one piece
  int count = 0;
  std::from_chars(statement.value.data(), statement.value.data() + statement.value.size(), count);
  return count >= 1 && count <= kMost && tells_cutting(lower_case(in_latin_letters(statement.key)));
}

}  // namespace

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
  statement.key = orders_cutting(statement) ? "quantity" : english_key(statement.key);
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
