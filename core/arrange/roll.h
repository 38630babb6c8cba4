#pragma once
// The cone or cylinder that a piece rolls up to which is sewn to itself.

#include <array>
#include <optional>
#include <vector>

#include "core/base/types.h"

namespace toile::arrange {

/// A rolled piece, the narrower end up.
struct Roll {
  Vec2 top, up;       ///< the middle of the upper end, m, in the piece's plane; unit vector
  double above = 0;   ///< m, around the upper end …
  double below = 0;   ///< … and the lower one
  double length = 0;  ///< m, of the seam
  double slope = 0;   ///< as sewing::WrappedPlacement::slope, where the seam's sides just meet
};

/// `seam`: points that its stitches bring together, m, from one end to the other. A cone's development is a
/// sector: the seam's two sides spread by its angle, beyond half a circle too, and a circle has it that is as
/// large a share of the whole as the slope. Which end of a straight tube is up, `grain` tells (unit vector).
/// Nothing for a seam without any length.
std::optional<Roll> roll_of(std::vector<std::array<Vec2, 2>> seam, Vec2 centroid, Vec2 grain);

}  // namespace toile::arrange
