#pragma once
// Edges in and beside the middle of the body: what mirrored pieces are sewn along, and vents and flies, which
// stay open. Merits are without a unit, as PairWeights (weights.h) has them.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether the run stands out by a step from a longer one that may lie in the middle: so do vents and flies.
bool stands_out(const SeamModel& m, const SeamRun& run);

/// Mirrored pieces meet in a straight line along the grain, as at a centre front, rather than along a hollow
/// (a neck, an armhole) or across the grain (a hem).
double twin_merit(const SeamModel& m, const SeamRun& run, double along_grain);

}  // namespace toile::seams
