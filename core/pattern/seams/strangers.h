#pragma once
// Pieces of a named garment that nothing is known of: a zip guard or a belt loop in words that no table has.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::seams {

/// Of each panel: whether others are sewn before it: it lies on other cloth (second_layers.h), or it is small
/// and neither its name nor its shape tells what it is, beside pieces whose names tell a front and a back.
/// REQUIRES a pattern that validate() accepts.
std::vector<char> sewn_last(const pattern::Pattern& pattern);

}  // namespace toile::seams
