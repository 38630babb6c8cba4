#pragma once
// Edges in and beside the middle of the body: what mirrored pieces are sewn along, and vents and flies, which
// stay open. Merits are without a unit, as PairWeights (weights.h) has them.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether the run, or the one that it runs on into, stands out by a step from a longer one along the grain:
/// so do vents and flies, in the middle of the body and at the hand.
bool stands_out(const SeamModel& m, const SeamRun& run);

/// Whether the piece turns in at an end of the run, as at the corner of a square neck; not where it goes out
/// to a vent.
bool turns_in(const SeamModel& m, const SeamRun& run);

/// Mirrored pieces meet in a straight line along the grain, as at a centre front, rather than along a hollow
/// (a neck, an armhole) or across the grain (a hem).
double twin_merit(const SeamModel& m, const SeamRun& run, double along_grain);

/// Whether a front that opens keeps the two apart: its round edge is sewn to linings and facings alone, no
/// edge to the other front's, and a collar above it is no ring.
bool stays_open(const SeamModel& m, const SeamRun& a, const SeamRun& b);

}  // namespace toile::seams
