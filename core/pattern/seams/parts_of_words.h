#pragma once
// Parts of words that tell what a piece is: signs of Chinese and Japanese, and what compounds are made of.

#include <span>

#include "core/pattern/seams/piece_terms.h"

namespace toile::seams {

/// Signs of Chinese and Japanese (UTF-8), which need no spaces: longer ones come first.
std::span<const PieceTerm> sign_terms();

/// What compound words begin and end with: "Rückenteil", "borstzak".
std::span<const PieceTerm> beginnings_of_words();
std::span<const PieceTerm> endings_of_words();

}  // namespace toile::seams
