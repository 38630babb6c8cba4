#pragma once
// Most edges whose boxes overlap are still too far from each other to matter. This sorts them out, two pairs
// at a time, before contact looks at the rest one by one.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/base/types.h"

namespace toile::collision {

/// An edge as the filter reads it: one cache line.
struct alignas(64) EdgeLine {
  Vec3 start, way;     ///< m; the edge runs from start to start + way
  double squared = 0;  ///< m², of the way's length
  double reach = 0;    ///< m; two edges may be near when their gap is under the sum of their reaches
};

EdgeLine edge_line(Vec3 from, Vec3 to, double reach);

using EdgePair = std::pair<Index, Index>;

/// The least gap of each of two pairs against its reach: bit k is clear only when pair k is surely out of
/// reach. The gap is that of closest_on_edges (core/geometry/distance.h), step by step.
unsigned near_ones(const EdgeLine* const (&a)[2], const EdgeLine* const (&b)[2]);

/// Calls visit(mine, theirs) for the pairs that may be near, in their order.
template <typename Visit>
void visit_near(std::span<const EdgePair> pairs, std::span<const EdgeLine> mine,
                std::span<const EdgeLine> theirs, Visit&& visit) {
  for (std::size_t first = 0; first < pairs.size(); first += 2) {
    const EdgeLine *a[2], *b[2];
    const std::size_t count = std::min<std::size_t>(2, pairs.size() - first);
    for (std::size_t k = 0; k < 2; ++k) {
      const EdgePair& pair = pairs[first + std::min(k, count - 1)];
      a[k] = &mine[pair.first];
      b[k] = &theirs[pair.second];
    }
    const unsigned near = near_ones(a, b);
    for (std::size_t k = 0; k < count; ++k) {
      if (near >> k & 1) visit(pairs[first + k].first, pairs[first + k].second);
    }
  }
}

}  // namespace toile::collision
