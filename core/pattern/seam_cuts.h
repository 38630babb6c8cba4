#pragma once
// Where an edge is likely to be sewn to several: a sleeve's cap at the armholes' ends, a band at a waist's.

#include "core/pattern/seam_model.h"

namespace toile {

/// The model with every run cut that is as long as two others together (each perhaps in parts, between darts)
/// whose neighbours are alike, so that these two would lie end to end when sewn: at their ends, in
/// proportion. Runs with a partner of their own length are left whole. `second_first` takes the two in the
/// other order.
SeamModel with_likely_cuts(const Pattern& pattern, SeamModel model, bool second_first);

}  // namespace toile
