#pragma once
// Pieces that are cut twice as often as they are worn: collars, cuffs, yokes and hoods are faced or lined
// with their own cloth.

#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Sets `words.layer` of pieces that are cut of a lining or an interlining, where others are not. REQUIRES
/// the model's words.
void find_layers_by_cloth(const pattern::Pattern& pattern, SeamModel& model);

/// Sets `words.layer` of the copies that lie on others, and so are for a person to sew. REQUIRES the model's
/// runs, words, `up`, lines and girths.
void find_second_layers(const pattern::Pattern& pattern, SeamModel& model);

/// Of each panel: whether it lies on other cloth, by its name or as such a copy. REQUIRES a pattern that
/// validate() accepts.
std::vector<char> lying_on_others(const pattern::Pattern& pattern);

}  // namespace toile::seams
