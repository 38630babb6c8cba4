#pragma once
// A strip under load, its ends free to narrow.

#include "core/material/fabric.h"

namespace toile::trials {

/// A strip of 50 by 200 mm that hangs, loaded over its whole length so that its middle stretches by half a
/// per cent: below every limit.
struct TensionResult {
  double known = 0;     ///< N/m, what it resists with where it may narrow: c11 − c12² / c22
  double measured = 0;  ///< N/m, load over strain
};

TensionResult tension(const material::Fabric& fabric, bool along_warp);

}  // namespace toile::trials
