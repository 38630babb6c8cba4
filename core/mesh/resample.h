#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::mesh {

/// A point of SampledPattern::edges.
struct EdgeSample {
  Index panel = kNone, edge = kNone, sample = kNone;
};

/// The two sides of a seam, point by point along side a. Where a corner is shared by two edges of a side,
/// each of them has its own entry.
struct SampledSeam {
  struct Pair {
    EdgeSample a, b;
  };
  std::vector<Pair> pairs;
  double length_a = 0, length_b = 0;  ///< m, along the curves
};

/// A pattern as polylines, metres.
struct SampledPattern {
  std::vector<std::vector<std::vector<Vec2>>>
      edges;                       ///< [panel][edge as edges_of counts][point], ends included
  std::vector<SampledSeam> seams;  ///< one per seam of the pattern
};

/// Divides every edge evenly by arc length into segments of about `particle_distance` (m), or of the panel's
/// own spacing; where a seam joins panels of different spacing the finer one counts on it. Edges of a seam
/// or parts of edges of a seam so that both sides have the same number of points (see seam_intervals), and
/// the ends of the parts are points. A loop of one edge has at least three segments, the edges of a loop of
/// two at least two.
///
/// Errors, with `where` naming piece and edge or the seam: "mesh.particle_distance", "mesh.not_finite",
/// "mesh.edge_without_length", "mesh.outline_open", "mesh.seam_edge" (an edge that does not exist, a
/// part that is empty or sewn twice, or a side without edges), "mesh.too_many_particles".
Result<SampledPattern> resample(const pattern::Pattern& pattern, double particle_distance);

}  // namespace toile::mesh
