#pragma once
// Fronts that lie over each other and are tied or buttoned there: of wrap skirts, wrap dresses and double
// rows of buttons. Worn, their middles lie on each other.

#include <span>
#include <vector>

#include "core/pattern/pattern.h"
#include "core/project/create/fold_lines.h"

namespace toile::create {

struct Wrap {
  Index panel = kNone;
  FoldLine middle;     ///< what lies beyond it, at its right, is the other front's place
  double long_as = 0;  ///< mm that the front goes on beyond it
};

/// Of fronts that are cut as a pair: a line drawn along the grain from hem to waist or neck, 60 to 260 mm
/// from the front's edge, that leaves about half a back, whereas the whole front is wider by far. `pairs`:
/// one a panel, whether it is cut twice, once turned over.
std::vector<Wrap> wraps(std::span<const pattern::Panel> panels, std::span<const char> pairs);

}  // namespace toile::create
