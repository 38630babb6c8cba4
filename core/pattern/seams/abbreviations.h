#pragma once
// Words that names of pieces shorten, as every office does in its own way: "DVT", "parmt", "espal".

#include <optional>
#include <string_view>

namespace toile::seams {

/// What the word (small letters without accents) shortens, in English. It is the beginning of a term of four
/// letters or more that ends with a consonant, or a term's letters without most of its vowels. Nothing where
/// the word is a term of its own, or terms of more than one meaning are shortened so and no English one among
/// them.
std::optional<std::string_view> spelled_out(std::string_view word);

/// Whether names of pieces in English have the word: of a piece, or of sizes, cloth, what is done with it.
bool is_common_word(std::string_view word);

}  // namespace toile::seams
