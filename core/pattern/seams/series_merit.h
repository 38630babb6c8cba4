#pragma once
// What speaks for two chains of runs as the sides of one seam, before the surface is looked at.

#include <optional>

#include "core/pattern/seams/chains.h"

namespace toile::seams {

/// Whether the chains are of cuffs, which go around a limb each.
bool are_of_two_cuffs(const SeamModel& model, const Chain& a, const Chain& b);

/// How far the neck of a front that opens goes on beyond the ends of a collar, mm: by what the fronts are
/// buttoned over each other; or the upper edge of a stand, whose ends are round. Nothing where that is no
/// such collar.
std::optional<double> beyond_collar(const SeamModel& model, const Chain& collar, const Chain& neck);

/// Whether the longer chain can be eased, gathered or stretched onto the shorter one.
bool lengths_fit(const SeamModel& model, const Chain& a, const Chain& b);

/// Merit of lengths, of corners that meet, and of what the pieces are.
double series_merit(const SeamModel& model, const Chain& a, const Chain& b);

}  // namespace toile::seams
