#pragma once
// Runs that no garment has sewn to each other.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether no garment has the two runs sewn to each other, whatever else it is: rings that no limb passes,
/// hoses of strips, necks and hoods shut, left legs on right ones.
bool never_meet(const SeamModel& model, const SeamRun& a, const SeamRun& b);

}  // namespace toile::seams
