#pragma once
// Seams of several edges on a side: a sleeve's cap to both armholes, a band to the pieces of a waist.

#include <vector>

#include "core/base/run_context.h"
#include "core/pattern/seams/search.h"

namespace toile::seams {

/// `found` with free runs sewn in series where that makes a better garment, the best first; runs are cut
/// where the corners of the other side come to lie. Runs that are `locked` stay free.
FoundSeams sewn_in_series(const pattern::Pattern& pattern, FoundSeams found, const std::vector<char>& locked,
                          const GluingSettings& settings, const RunContext& context);

}  // namespace toile::seams
