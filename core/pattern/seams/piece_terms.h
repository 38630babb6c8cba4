#pragma once
// The trade's words for pieces of a garment, as patterns of many countries have them. From general
// dictionaries and the habits of drafting programs.

#include <optional>
#include <span>
#include <string_view>

namespace toile::seams {

struct PieceTerm {
  std::string_view theirs, english;
};

/// What a word, or two words in a row with a space between, is in English: small letters without accents.
std::optional<std::string_view> english_of(std::string_view term);

/// All of those words, in no order that means anything.
std::span<const PieceTerm> all_terms();

}  // namespace toile::seams
