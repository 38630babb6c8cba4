#pragma once
// Letters with accents and Cyrillic ones as plain Latin letters.

#include <string>
#include <string_view>

namespace toile {

/// The text (UTF-8) with the letters of U+00C0 to U+017F without what is above or below them, those of
/// Romanian with a comma below, and those of Russian and Ukrainian as they are written in Latin letters,
/// small ones; all else stays. Bytes that are no UTF-8 stay as well.
std::string in_latin_letters(std::string_view text);

}  // namespace toile
