#pragma once
// Finds the set of seams that makes the best garment of a pattern's pieces.

#include <vector>

#include "core/base/run_context.h"
#include "core/pattern/seams/gluing.h"

namespace toile::seams {

/// Runs sewn as one seam: run k of `a` meets run k of `b`. Both sides in the order in which one walks side a
/// with the cloth at the left.
struct FoundSeam {
  std::vector<Index> a, b;
  double margin = 0;  ///< merit that the best garment without this seam lacks
};

struct FoundSeams {
  SeamModel model;  ///< runs cut where the corners of the other side come to lie
  SeamGluing gluing;
  std::vector<FoundSeam> seams;
};

/// Searches by threshold acceptance (Dueck and Scheuer 1990) with a fixed sequence of numbers: the same
/// pattern gives the same seams. `sewn` holds pairs of runs that are seams already; `blocked` runs take no
/// part. A cancelled search returns what it has.
FoundSeams search_seams(const pattern::Pattern& pattern, const std::vector<std::array<Index, 2>>& sewn,
                        const std::vector<Index>& blocked, const GluingSettings& settings,
                        const RunContext& context);

}  // namespace toile::seams
