#pragma once
// Morton (Z) order of grid points: points near in the plane are near in the order.

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/grid_predicates.h"

namespace toile::mesh {

/// Bits of x and y interleaved, x lowest. x and y in 0 … 2^32 - 1.
std::uint64_t morton_code(const GridPoint& p);

/// Indices of the first `count` points (all non-negative), sorted by code, then by index.
std::vector<Index> morton_order(std::span<const GridPoint> points, Index count);

}  // namespace toile::mesh
