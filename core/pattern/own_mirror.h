#pragma once
// Pieces that look the same turned over.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::pattern {

/// The lines, as unit vectors, about which the outline is its own mirror image: its corners and edges come in
/// the same order both ways around, within half a millimetre. Outlines of a single edge have none.
std::vector<Vec2> mirror_axes(const Loop& loop);

/// Whether there is one.
bool is_own_mirror(const Loop& loop);

}  // namespace toile::pattern
