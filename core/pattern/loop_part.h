#pragma once
// A part of an outline, or of one of its edges, from one place on it to another.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::pattern {

/// The edges of the loop from its place nearest to `from` on to the one nearest to `to`, mm, those broken in
/// which it begins and ends; their ids are empty. Places are found within 0.05 mm along curves.
std::vector<PanelEdge> edges_between(const Loop& loop, Vec2 from, Vec2 to);

/// The curves of the edge from a share of its length to another; those that are taken whole keep their ends
/// exactly. REQUIRES 0 <= from < to <= 1.
std::vector<CubicBezier> curves_between(const PanelEdge& edge, double from, double to);

}  // namespace toile::pattern
