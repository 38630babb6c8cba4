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

/// A seam all around whose start lies within an edge that is sewn to several, from that edge's end instead: a
/// cap is set in from under the arm, wherever the search began.
FoundSeam begun_at_an_end(const FoundSeams& found, FoundSeam seam);

}  // namespace toile::seams
