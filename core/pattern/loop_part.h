#pragma once
// A part of an outline, from one place on it to another.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::pattern {

/// The edges of the loop from its place nearest to `from` on to the one nearest to `to`, mm, those broken in
/// which it begins and ends; their ids are empty. Places are found within 0.05 mm along curves.
std::vector<PanelEdge> edges_between(const Loop& loop, Vec2 from, Vec2 to);

}  // namespace toile::pattern
