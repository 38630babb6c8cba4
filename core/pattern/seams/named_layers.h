#pragma once
// Pieces that lie on others as their names tell in words that no table has: "VYZTUZ LIMEC" beside "LIMEC".

#include "core/pattern/pattern.h"
#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Sets `words.layer` of pieces that are called as others are and a word besides that nobody knows, where two
/// at least that have this word are of the others' forms: interlinings or linings in any language. Those that
/// have it and are larger stay. REQUIRES the model's runs, words and `up`.
void find_named_layers(const pattern::Pattern& pattern, SeamModel& model);

}  // namespace toile::seams
