#pragma once
// Stands of collars with round ends, whose upper edge goes on around the ends down to the neck.

#include <vector>

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Of a stand whose outline has two edges: +1 for the upper one with the round ends, which is the longer one,
/// −1 for the one that is sewn to the neck; 0 of anything else. Of a part the same as of its edge.
int round_stand_edge(const SeamModel& model, const SeamRun& run);

/// Whether one run is of such a stand's edge, and the other belongs to its other one: a collar sits with its
/// length on the upper edge, which nothing else meets, and the lower one is the neck's.
bool misses_round_stand(const SeamModel& model, const SeamRun& a, const SeamRun& b);

/// Whether the runs are the edge along which a collar sits on a stand, the shorter one of its long edges.
bool is_inner_of_collar(const SeamModel& model, const std::vector<Index>& runs);

}  // namespace toile::seams
