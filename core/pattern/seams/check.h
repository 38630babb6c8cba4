#pragma once
// What may be wrong with a pattern's seams, beyond what validate() refuses.

#include <string>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile {

struct SeamIssue {
  std::string code;     ///< see check_seams
  bool error = false;   ///< else a warning: it can be sewn, but is hardly meant
  std::string message;  ///< with lengths in mm
  std::string where;    ///< "seam s1, side b, item 2 (piece front, edge hem)"
  Index panel = kNone;
  Vec2 at;  ///< mm, on that panel
};

/// Looks at every seam, in order. REQUIRES a pattern that validate() accepts, or refuses for its seams alone.
///
/// Errors: seam.reference (an edge that is not there), seam.range, seam.sewn_twice, seam.empty_side.
/// Warnings: seam.not_continuous (a series whose next edge starts neither where the last one ends nor where
/// other seams bring that to), seam.twisted (the seam runs the other way than its neighbours say, or makes a
/// surface of one side), seam.length_ratio (over 1:3), seam.open_loop (one side comes back to its start and
/// the other does not).
std::vector<SeamIssue> check_seams(const Pattern& pattern);

/// Length of the series, mm, along its curves. REQUIRES edges that are there.
double series_length(const Pattern& pattern, const std::vector<SeamEdge>& series);

}  // namespace toile
