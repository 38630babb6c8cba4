#include "core/base/latin_letters.h"

#include <array>
#include <cstddef>

namespace toile {
namespace {

/// The letters of U+00C0 to U+017F without what is above or below them; '?' is none of ASCII, or two.
constexpr std::string_view kBareLetters =
    "AAAAAA?CEEEEIIII?NOOOOO?OUUUUY??aaaaaa?ceeeeiiii?nooooo?ouuuuy?y"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIi??JjKkkLlLlLlLlLlNnNnNnnNnOoOoOo??RrRrRrSsSsSsSsTtTtTt"
    "UuUuUuUuUuUuWwYyYZzZzZzs";
static_assert(kBareLetters.size() == 0x180 - 0xC0);

/// What a letter of U+00C0 to U+017F is written as without accents.
std::string bare(unsigned letter) {
  switch (letter) {
    case 0xC6:
    case 0xE6:
      return "ae";
    case 0xDF:
      return "ss";
    case 0x152:
    case 0x153:
      return "oe";
    default:
      return std::string(1, kBareLetters[letter - 0xC0]);
  }
}

/// U+0430 to U+044F.
constexpr std::array<std::string_view, 32> kCyrillic{
    "a", "b", "v", "g", "d", "e",  "zh", "z",  "i",  "y",    "k", "l", "m", "n", "o",  "p",
    "r", "s", "t", "u", "f", "kh", "ts", "ch", "sh", "shch", "",  "y", "",  "e", "yu", "ya"};

/// S and T with a comma below, of Romanian (U+0218 to U+021B); null for other letters.
const char* bare_romanian(unsigned letter) {
  constexpr std::array<const char*, 4> kLetters{"S", "s", "T", "t"};
  return letter >= 0x218 && letter <= 0x21B ? kLetters[letter - 0x218] : nullptr;
}

/// What a letter of U+0400 to U+047F is written as; empty: it is none of Russian or Ukrainian, or mute.
std::string_view latin_of_cyrillic(unsigned letter) {
  if (letter >= 0x430 && letter <= 0x44F) return kCyrillic[letter - 0x430];
  if (letter >= 0x410 && letter <= 0x42F) return kCyrillic[letter - 0x410];
  switch (letter) {
    case 0x401:
    case 0x451:
      return "e";
    case 0x404:
    case 0x454:
      return "ye";
    case 0x406:
    case 0x456:
      return "i";
    case 0x407:
    case 0x457:
      return "yi";
    case 0x490:
    case 0x491:
      return "g";
    default:
      return "";
  }
}

/// Whether the byte goes on a letter of UTF-8.
bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80; }

}  // namespace

std::string in_latin_letters(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool accented = byte >= 0xC3 && byte <= 0xC5, cyrillic = byte >= 0xD0 && byte <= 0xD2;
    const bool two = i + 1 < text.size() && goes_on(text[i + 1]);
    const unsigned letter = two ? (byte & 0x1Fu) << 6 | (static_cast<unsigned char>(text[i + 1]) & 0x3Fu) : 0;
    const char* romanian = byte == 0xC8 && two ? bare_romanian(letter) : nullptr;
    if (!two || (!accented && !cyrillic && romanian == nullptr)) {
      out += text[i];
      continue;
    }
    if (romanian != nullptr)
      out += romanian;
    else
      out += accented ? bare(letter) : std::string(latin_of_cyrillic(letter));
    ++i;
  }
  return out;
}

}  // namespace toile
