#pragma once
// Whether one closed line is the sew line within another, the cut line.

#include "core/pattern/dxf/nest.h"

namespace toile::dxf {

/// What the drawing says of a line that may be a sew line.
enum class DxfSewClaim {
  kSaid,      ///< it stands on the layer of sew lines: its shape has to contradict that
  kPossible,  ///< nothing, or that it is a line within the piece: its shape has to prove it
};

/// Whether the inner loop follows the outer one at the widths of seam allowances. Each seam may have its own
/// width, a hem a wide one, a fold none; the sew line may run into darts that the cut line passes over, and
/// leave the cut line by a little where it should lie on it.
bool is_seam_line(const DxfLoop& inner, const DxfLoop& outer, DxfSewClaim claim);

}  // namespace toile::dxf
