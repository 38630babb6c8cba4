#pragma once

#include "core/base/result.h"
#include "core/pattern/pattern.h"

namespace toile::pattern {

/// Whether the pattern can be cut and sewn: ids there and unique; coordinates finite and within a kilometre;
/// loops closed exactly, outlines counter-clockwise and holes clockwise, with area, not crossing or touching
/// themselves or each other, holes inside the outline and beside each other; grain a unit vector; seams with
/// both sides, whose edges exist, and no part of an edge sewn twice.
///
/// Errors name the place in `where`, such as "piece front, edge e3" or "seam side_left, side a, item 0":
/// pattern.missing_id, pattern.duplicate_id, pattern.not_finite, pattern.too_large, pattern.empty_edge,
/// pattern.open_outline, pattern.zero_area, pattern.clockwise, pattern.self_crossing, pattern.hole_outside,
/// pattern.bad_grain, pattern.bad_line (of under two points, with a step under 0.01 mm, outside the piece or
/// across its outline), pattern.empty_seam_side, pattern.seam_reference, pattern.seam_range,
/// pattern.edge_sewn_twice.
Status validate(const Pattern& pattern);

/// The same for one piece by itself.
Status validate(const Panel& panel);

/// Whether its outline and holes cross or touch, or a hole lies outside of the cloth, and nothing worse is
/// wrong with it: what validate(panel) would tell as pattern.self_crossing or pattern.hole_outside.
bool has_crossing_lines(const Panel& panel);

}  // namespace toile::pattern
