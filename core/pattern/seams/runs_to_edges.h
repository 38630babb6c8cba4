#pragma once
// The runs that a search has sewn, as edges of the pattern.

#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/seams/search.h"

namespace toile::seams {

/// The edges of runs that are walked with the cloth at the left, parts of one edge that follow each other put
/// together again; `length` grows by theirs, mm.
std::vector<pattern::SeamEdge> edges_of_runs(const FoundSeams& found, const std::vector<Index>& runs,
                                             double& length);

/// A seam of one whole edge to several, with that edge walked from its end; `around`: both sides are rings,
/// and the other one begins where it goes on along another edge, that of a sleeve under the arm. A cap is set
/// in from there, wherever the search began to walk. Others stay.
FoundSeam begun_at_an_end(const FoundSeams& found, FoundSeam seam, bool around);

}  // namespace toile::seams
