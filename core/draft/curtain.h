#pragma once

#include "core/draft/garment.h"

namespace toile::draft {

/// Millimetres.
struct CurtainStyle {
  double rail = 1500;     ///< length between its knobs
  double covered = 500;   ///< of the rail by each curtain, drawn aside
  double fullness = 2;    ///< cloth for each length of rail that it covers
  double drop = 1300;     ///< from the tape to the hem, which just clears the sill
  double heading = 70;    ///< height of the stiffened strip at the top
  double tape = 40;       ///< sits so far above the strip's lower edge
  double rail_at = 1500;  ///< height
  int hooks = 12;         ///< of each curtain
};

/// A pair of curtains, left and right as one looks at the window: a "curtain" and a fused "heading" each,
/// drawn up by a tape and hung on a rail by hooks.
///
/// J. W. Stephenson, "Cutting and Draping" (1905): cloth twice as wide as what it covers, a heading of about
/// an inch above a narrow tape by which it is shirred to its width, a hem that just clears the sill. The tape
/// is elastic that is as much shorter than the cloth; the hooks that sit on it are led to their places along
/// the rail. Sizes are the project's.
Garment draft_curtain(const CurtainStyle& style = {});

}  // namespace toile::draft
