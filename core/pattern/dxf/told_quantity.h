#pragma once
// How often a piece is cut, where names and labels tell it in passing: "SLEEVE 2x", "couper 1 paire".

#include <optional>
#include <string_view>

#include "core/pattern/dxf/words.h"

namespace toile::dxf {

/// What the text tells: a figure with a word of cutting or counting, of a dozen languages, or with an x, or a
/// word for a pair. What is cut on the fold is told apart, since none of it is turned over. Nothing where it
/// tells of no quantity, as "5 x 5" or "size 38".
std::optional<DxfQuantity> told_quantity(std::string_view text);

/// Whether that is all that the text tells: it is no piece's name.
bool tells_only_quantity(std::string_view text);

/// Whether the text begins with how often the piece is cut, whatever it says of that: "TAGLIARE 2 (DX+SX)",
/// "cut 2 fabric + 2 fusible".
bool is_cutting_order(std::string_view text);

/// Whether the text begins with a figure and a word of counting or an x, whatever follows: "2 volte stoffa",
/// "x2 en vis-à-vis". It may be a name all the same.
bool begins_with_count(std::string_view text);

/// Whether the word (small Latin letters) is one for a fold of cloth.
bool is_fold_word(std::string_view word);

/// Whether the word says nothing by itself where a text tells how a piece is cut: "on", "the", "x".
bool is_beside_word(std::string_view word);

}  // namespace toile::dxf
