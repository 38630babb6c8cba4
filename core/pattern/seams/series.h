#pragma once
// Seams of several edges on a side: a sleeve's cap to both armholes, a band to the pieces of a waist.

#include <vector>

#include "core/base/run_context.h"
#include "core/pattern/seams/search.h"

namespace toile::seams {

/// Sews free runs of `found` in series where that makes a better garment, the best first, cutting runs where
/// the corners of the other side come to lie; adds the seams to found.seams. Runs that are `locked` stay
/// free.
void sew_series(const pattern::Pattern& pattern, FoundSeams& found, const std::vector<char>& locked,
                const GluingSettings& settings, const RunContext& context);

}  // namespace toile::seams
