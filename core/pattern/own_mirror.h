#pragma once
// Pieces that look the same turned over.

#include "core/pattern/pattern.h"

namespace toile::pattern {

/// Whether the outline is its own mirror image, about any line: its corners and edges come in the same order
/// both ways around, within half a millimetre.
bool is_own_mirror(const Loop& loop);

}  // namespace toile::pattern
