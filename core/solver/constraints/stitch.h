#pragma once
// Threads that draw sewn vertices together. Each keeps its own length, which shrinks from what it was at the
// start to zero, so that all stitches of a garment arrive together.

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::solver::constraints {

struct Stitch {
  Index v0 = kNone, v1 = kNone;  ///< vertices of the solver
  double start_length = 0;       ///< m
  double force_limit = 0.5;      ///< N; contact is stronger than any thread
};

/// Vertices that stitches join, directly or through others: they end as one.
struct StitchGroup {
  std::vector<Index> vertices;
  double force_limit = 0.5;  ///< N, on each vertex
};

/// Groups of a set of stitches, in order of their least vertex.
std::vector<StitchGroup> stitch_groups(std::span<const Stitch> stitches, Index vertex_count);

/// One pass: every stitch is at most `shrunk`·start_length long (1 at the start).
void shorten_stitches(std::span<const Stitch> stitches, double shrunk, std::span<const double> w, double h,
                      std::span<Vec3> x);

/// One pass with the threads at no length: every group is drawn to its centre of mass. Stitch by stitch,
/// where seams cross, closing one would open the next.
void close_groups(std::span<const StitchGroup> groups, std::span<const double> w, double h,
                  std::span<Vec3> x);

/// The largest distance of a stitch's ends, m; 0 without stitches.
double largest_gap(std::span<const Stitch> stitches, std::span<const Vec3> x);

}  // namespace toile::solver::constraints
