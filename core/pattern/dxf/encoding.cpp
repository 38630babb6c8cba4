#include "core/pattern/dxf/encoding.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/text.h"

namespace toile::dxf {

std::size_t utf8_length(std::string_view s) {
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

namespace {

bool is_utf8(std::string_view s) {
  while (!s.empty()) {
    const std::size_t n = utf8_length(s);
    if (n == 0) return false;
    s.remove_prefix(n);
  }
  return true;
}

/// Whether a text that is UTF-8 by its form holds letters that nobody writes patterns with (rare extensions
/// of Latin, Armenian): many pairs of GB 2312 have that form.
bool has_rare_letters(std::string_view s) {
  for (std::size_t i = 0; i < s.size(); i += std::max<std::size_t>(1, utf8_length(s.substr(i)))) {
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

/// Whether the only high bytes are two amid small letters, as in "Gr\xF6\xDFe" or "cr\xE9\xE9": letters of
/// Europe, though two of them make a Chinese one.
bool is_pair_in_a_word(std::string_view s) {
  const auto is_high = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
  if (std::count_if(s.begin(), s.end(), is_high) != 2) return false;
  const auto at = std::size_t(std::find_if(s.begin(), s.end(), is_high) - s.begin());
  return at > 0 && s[at - 1] >= 'a' && s[at - 1] <= 'z';
}

struct Converted {
  std::string text;
  bool whole = false;  ///< every byte had a letter
};

/// The first letters of Unicode, which Windows 1252 agrees with but for 27 signs.
Converted from_latin(std::string_view s) {
  Converted out;
  for (const char c : s) {
    const unsigned byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) out.text += char(0xC0 | (byte >> 6));
    out.text += byte < 0x80 ? c : char(0x80 | (byte & 0x3F));
  }
  return out;
}

Converted converted(std::string_view s, const char* code_page) {
  const iconv_t converter = iconv_open("UTF-8", code_page);
  if (reinterpret_cast<std::intptr_t>(converter) == -1)
    return from_latin(s);  // a machine without tables of letters
  constexpr std::size_t kMostPerByte = 4;
  std::string in(s), out(s.size() * kMostPerByte + 8, '\0');
  char *from = in.data(), *to = out.data();
  std::size_t left = in.size(), room = out.size();
  bool whole = true;
  while (iconv(converter, &from, &left, &to, &room) == std::size_t(-1) && left > 0) {
    whole = false;
    ++from;
    --left;
  }
  iconv_close(converter);
  out.resize(out.size() - room);
  return {std::move(out), whole};
}

}  // namespace

DxfEncoding encoding_of(std::string_view code_page) {
  const std::string name = lower_case(code_page);
  if (name.starts_with("gb")) return {"GBK"};
  if (name.find("8859") != std::string::npos) return {"ISO-8859-1"};
  static constexpr std::array<std::pair<std::string_view, const char*>, 20> kPages{
      {{"1250", "CP1250"}, {"1251", "CP1251"}, {"1253", "CP1253"}, {"1254", "CP1254"}, {"1255", "CP1255"},
       {"1256", "CP1256"}, {"1257", "CP1257"}, {"1258", "CP1258"}, {"874", "CP874"},   {"932", "CP932"},
       {"936", "GBK"},     {"949", "CP949"},   {"950", "BIG5"},    {"437", "CP437"},   {"850", "CP850"},
       {"852", "CP852"},   {"855", "CP855"},   {"857", "CP857"},   {"865", "CP865"},   {"866", "CP866"}}};
  for (const auto& [figures, page] : kPages)
    if (name.ends_with(figures)) return {page};
  return {};
}

std::string utf8_of(std::string_view s, DxfEncoding encoding) {
  const bool told = encoding.code_page != nullptr;
  const bool guess = !told && in_pairs(s) && !is_pair_in_a_word(s) && (!is_utf8(s) || has_rare_letters(s));
  if (guess)
    if (Converted chinese = converted(s, "GBK"); chinese.whole) return std::move(chinese.text);
  if (is_utf8(s)) return std::string(s);
  return converted(s, told ? encoding.code_page : "CP1252").text;
}

}  // namespace toile::dxf
