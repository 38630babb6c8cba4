#pragma once
// What may be wrong with a pattern's seams, beyond what validate() refuses.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::seams {

enum class SeamIssueKind : std::uint8_t {
  kReference,      ///< an edge that is not there
  kRange,          ///< no part of its edge
  kSewnTwice,      ///< a part of an edge that another seam has already
  kEmptySide,      ///< a side without edges
  kNotContinuous,  ///< a series whose next edge starts neither where the last one ends nor where other seams
                   ///< bring that to
  kTwisted,        ///< it runs the other way than its neighbours say, or makes a surface of one side
  kLengthRatio,    ///< over 1:3
  kOpenLoop,       ///< one side comes back to its start and the other does not
};
inline constexpr std::size_t kSeamIssueKindCount = static_cast<std::size_t>(SeamIssueKind::kOpenLoop) + 1;

/// "seam.reference", …: as the service has it.
std::string_view code_of(SeamIssueKind kind);
/// Else a warning: it can be sewn, but is hardly meant.
bool is_error(SeamIssueKind kind);

struct SeamIssue {
  SeamIssueKind kind = SeamIssueKind::kReference;
  Index seam = kNone;   ///< in Pattern::seams, that it is about
  std::string message;  ///< with lengths in mm
  std::string where;    ///< "seam s1, side b, item 2 (piece front, edge hem)"
  Index panel = kNone;
  Vec2 at;  ///< mm, on that panel
};

/// Looks at every seam, in order. REQUIRES a pattern that validate() accepts, or refuses for its seams alone.
std::vector<SeamIssue> check_seams(const pattern::Pattern& pattern);

/// Length of the series, mm, along its curves. REQUIRES edges that are there.
double series_length(const pattern::Pattern& pattern, const std::vector<pattern::SeamEdge>& series);

}  // namespace toile::seams
