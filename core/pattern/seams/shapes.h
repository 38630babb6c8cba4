#pragma once
// What the shapes of two runs say of sewing them to each other, and how runs lie on their pieces. Merits are
// without a unit, as PairWeights (weights.h) has them.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// From the run's start to its end, mm.
Vec2 chord(const SeamRun& run);

/// Degrees between the directions of the run that differ most.
double bend_of(const SeamRun& run);

/// For curves that are alike, against a straight edge sewn to a round one.
double shape_merit(const SeamRun& a, const SeamRun& b);

/// Pieces mostly lie as they are worn, so that the upper ends of two edges belong together: the correlation
/// of the two edges' heights along the grain, -1 to 1; 0 where one is level or its piece may not be upright.
double height_merit(const SeamModel& m, const SeamRun& a, const SeamRun& b, bool along);

/// How much the run runs along the grain, 0 to 1.
double rise(const SeamModel& m, const SeamRun& run);

/// Share of the longer one by which the lengths differ.
double difference(const SeamRun& a, const SeamRun& b);

/// Whether the run may lie in the middle of the body: straight along the grain.
bool is_middle(const SeamModel& m, const SeamRun& run);

/// Two edges that run into a narrow corner: what is no dart is a slit, or another piece is let in.
bool is_slit(const SeamModel& m, const SeamRun& a, Index i, const SeamRun& b, Index j);

/// Whether the run meets a hem, as sides do, however hollow they are under the arm of a wide sleeve; no
/// armhole does.
bool begins_at_hem(const SeamModel& m, const SeamRun& run);

/// 1 where run r of a piece that is its own mirror image is of its right half as drawn upright, -1 of its
/// left one, 0 where that is not known.
int half_of(const SeamModel& m, Index r);

/// Notches that meet speak for the pair, those that are left over a little against it.
double notch_merit(const SeamRun& a, const SeamRun& b, bool along);

}  // namespace toile::seams
