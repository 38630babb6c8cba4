#pragma once
// What the names of two pieces say of sewing a run of one to a run of the other: their kinds, sides, faces
// and numbers. Merits are without a unit, as PairWeights (weights.h) has them.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether one of the runs is the lower end of a piece and the other the upper one of a piece that hangs from
/// it, by their names: +1; −1 where they say the contrary; else 0.
int told_to_hang(const SeamModel& m, const SeamRun& a, const SeamRun& b);

/// Whether a sleeve is sewn to a bodice, which is no longer than it: caps are often gathered, but for those
/// of tailored sleeves, which are eased.
bool is_cap(const SeamModel& m, const SeamRun& a, const SeamRun& b);

/// Whether one of the runs is of a collar or a hood: the neck's length is theirs, and nothing is gathered
/// there.
bool on_neck(const SeamModel& m, const SeamRun& a, const SeamRun& b);

/// Whether both runs are of a bodice.
bool are_torsos(const SeamModel& m, Index i, Index j);

/// A side's edges in the middle of the body go to the other side's, not to its own; its other edges do not.
double middle_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b);

/// Whether one half, of a bodice or of trousers, would have all of an edge that both halves come to.
bool takes_both_halves(const SeamModel& m, Index i, Index j);

/// What the kinds of the two pieces say; `hangs` is told_to_hang() of the runs.
double kind_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b, int hangs);

/// Whether the run goes from the hem of a bodice, or on from its side, in a wide bend to the wrist of a
/// sleeve that is cut on.
bool sweeps_to_wrist(const SeamModel& m, const SeamRun& run);

/// What the runs' facing up and down says: hems, waists, what hangs below what.
double facing_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b);

/// `alike`: the two edges are the same one of two pieces that are drawn alike; `middle`: both may lie in the
/// middle of the body.
double name_merit(const PieceWords& a, const PieceWords& b, bool twins, bool alike, bool middle);

/// Pieces of a row are sewn in their order.
double row_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b);

}  // namespace toile::seams
