#pragma once
// A piece sheared along its threads, held at two sides: what KES-FB1 measures (S. Kawabata, "The
// Standardization and Analysis of Hand Evaluation", 1980), with weight for its load.

#include "core/material/fabric.h"

namespace toile::trials {

/// A piece of 50 mm between its held sides and 200 mm along them, in which the load along those sides grows
/// from nothing in the middle, so that its threads are sheared by half a degree at most.
struct ShearResult {
  double known = 0;     ///< N/m per radian, the fabric's own
  double measured = 0;  ///< N/m per radian: load over shear
};

ShearResult shear(const material::Fabric& fabric);

}  // namespace toile::trials
