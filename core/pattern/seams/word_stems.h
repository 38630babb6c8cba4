#pragma once
// Words of pieces in a form that no table has: "kapsou", "delanteros", "Vyztuz" beside "vyztuha".

#include <optional>
#include <string_view>

namespace toile::seams {

/// What a word (small letters without accents) is in English that differs from a term (piece_terms.h) in its
/// ending alone: five letters in common, and no more than two besides on either side. Nothing where terms of
/// several meanings do. Of the terms themselves, each told by the others, 94 of 100 that have an answer so
/// are right, and most others near: a belt as a waistband.
std::optional<std::string_view> english_by_stem(std::string_view word);

}  // namespace toile::seams
