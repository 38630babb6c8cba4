#pragma once
// Which constraints are solved together, and which packs of them side by side on several threads. A pass is
// Gauss-Seidel: what comes later works with what came before, so the order is part of the data and the number
// of threads is not. Large cloth is cut into strips along its mesh: every second strip shares no vertex with
// another, since a whole strip lies between them. They are solved in one round, those between in the next.

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::solver::lanes {

inline constexpr int kLanes = 16;

/// Constraints of one pack, kNone where it has fewer.
using LaneGroup = std::array<Index, kLanes>;

/// Strips of a round, at most: each has a point of its own for lanes without a constraint.
inline constexpr int kMostSideBySide = 16;

struct PackRange {
  std::size_t begin = 0, end = 0;  ///< packs
};

struct PackPlan {
  std::vector<LaneGroup> groups;                 ///< the packs, in the order of their strips
  std::vector<Index> side;                       ///< of each pack: which strip of its round it is in
  std::array<std::vector<PackRange>, 2> rounds;  ///< one after the other; their strips side by side
};

/// The vertices of a constraint, kNone for none.
using VerticesOf = std::function<std::span<const Index>(Index)>;

/// Each of `count` constraints once. Cloth that is not worth it is one strip.
PackPlan plan_packs(Index count, Index vertex_count, const VerticesOf& vertices);

/// Constraints of `of` that share no vertex, up to sixteen together, each once; in order, but for what had to
/// wait.
std::vector<LaneGroup> group_apart(std::span<const Index> of, Index vertex_count, const VerticesOf& vertices);

/// For each constraint how far it lies from one end of the mesh it belongs to, in constraints: two that share
/// a vertex differ by one at most.
std::vector<Index> levels_of(Index count, Index vertex_count, const VerticesOf& vertices);

}  // namespace toile::solver::lanes
