#include "core/base/latin_letters.h"

#include <array>
#include <cstddef>
#include <optional>

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

/// S and T with a comma below, of Romanian (U+0218 to U+021B); empty for other letters.
std::string_view latin_of_romanian(unsigned letter) {
  constexpr std::array<std::string_view, 4> kLetters{"S", "s", "T", "t"};
  return letter >= 0x218 && letter <= 0x21B ? kLetters[letter - 0x218] : "";
}

/// What a letter of two bytes is written as; nothing for those that stay.
std::optional<std::string> latin_of(unsigned letter) {
  if (letter >= 0xC0 && letter <= 0x17F) return bare(letter);
  if (letter >= 0x400 && letter <= 0x4BF) return std::string(latin_of_cyrillic(letter));
  const std::string_view romanian = latin_of_romanian(letter);
  return romanian.empty() ? std::nullopt : std::optional<std::string>(romanian);
}

/// Whether the byte goes on a letter of UTF-8.
bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80; }

}  // namespace

std::string in_latin_letters(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool two = byte >= 0xC3 && byte <= 0xDF && i + 1 < text.size() && goes_on(text[i + 1]);
    const std::optional<std::string> latin =
        two ? latin_of((byte & 0x1Fu) << 6 | (static_cast<unsigned char>(text[i + 1]) & 0x3Fu))
            : std::nullopt;
    out += latin ? *latin : std::string(1, text[i]);
    i += latin ? 1 : 0;
  }
  return out;
}

}  // namespace toile
