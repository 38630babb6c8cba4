#pragma once

#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/seams/piece_words.h"

namespace toile::seams {

/// What the names of a garment's pieces tell, and where they leave something open its other pieces and its
/// shapes; one per panel. REQUIRES a pattern that validate() accepts.
std::vector<PieceWords> garment_words(const pattern::Pattern& pattern);

}  // namespace toile::seams
