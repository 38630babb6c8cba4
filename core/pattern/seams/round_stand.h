#pragma once
// Stands of collars, whose edges tell by their lengths which of them the neck's is.

#include <vector>

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Of a stand +1 for the edge on which the collar sits, −1 for the one that is sewn to the neck; 0 of
/// anything else. They are its two longest. Where it has round ends and so no edges there (two edges in all,
/// or three of a half), the upper one goes on around them and is longer, else it is the shorter one. Of a
/// part the same as of its edge.
int round_stand_edge(const SeamModel& model, const SeamRun& run);

/// Whether one run is of such a stand's edge, and the other belongs to its other one: a collar sits with its
/// length on the upper edge, which nothing else meets, and the lower one is the neck's.
bool misses_round_stand(const SeamModel& model, const SeamRun& a, const SeamRun& b);

/// Whether the runs are the edge along which a collar sits on a stand, the shorter one of its long edges.
bool is_inner_of_collar(const SeamModel& model, const std::vector<Index>& runs);

}  // namespace toile::seams
