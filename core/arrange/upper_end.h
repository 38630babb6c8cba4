#pragma once
// Which end of a piece is worn upwards.

#include <vector>

#include "core/arrange/garment_graph.h"

namespace toile::arrange {

/// In the plane of piece `p`, m: from its middle to where pieces that are worn higher are sewn to it, or legs
/// to each other; along its grain where there are none. `partner`: of each piece the one that mirrors
/// it, kNone.
Vec2 upper_end(const GarmentGraph& graph, const std::vector<Index>& partner, Index p);

}  // namespace toile::arrange
