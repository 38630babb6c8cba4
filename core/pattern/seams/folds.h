#pragma once
// Folds of doubled cloth, and what is never sewn along them.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether one of the runs is a fold to which the other is not sewn: nothing is but the fold of the mirrored
/// piece, where both are as long as a front's edge, since bands along two fronts are buttoned there; one that
/// goes on around the neck stays open. The long edges opposite two such folds are for what they are sewn to,
/// and do not meet either.
bool never_at_fold(const SeamModel& model, const SeamRun& a, const SeamRun& b);

}  // namespace toile::seams
