#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::mesh {

/// A stretch of a seam between two corners: from a0 to a1 along side a, from b0 to b1 along side b (m), both
/// cut into `segments` equal parts.
struct SeamInterval {
  double a0 = 0, a1 = 0, b0 = 0, b1 = 0;
  Index segments = 1;
};

/// Cuts both sides of a seam at the corners of either. `breaks_a` and `breaks_b` are the distances (m) of
/// each side's corners from its start: strictly increasing, from 0 to the side's length. Corners that lie
/// closer than kMergeDistance · `particle_distance` on the longer side, when both sides are scaled to it,
/// meet; the others get a partner in proportion. As many segments as the longer side of a stretch asks for.
std::vector<SeamInterval> seam_intervals(std::span<const double> breaks_a, std::span<const double> breaks_b,
                                         double particle_distance);

inline constexpr double kMergeDistance = 0.35;  ///< particle distances; see seam_intervals

/// Segments that a line of `length` gets: as near to the particle distance as whole numbers allow.
Index segment_count(double length, double particle_distance);

}  // namespace toile::mesh
