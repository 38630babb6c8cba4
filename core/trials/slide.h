#pragma once
// A piece that slides down a slope: ISO 8295 and ASTM D1894 pull a sled instead, which asks the same.

#include "core/material/fabric.h"

namespace toile::trials {

/// A piece of 100 by 100 mm on a plane clad in the same fabric, ten degrees steeper than it begins to slide.
struct SlideResult {
  double known = 0;     ///< Coulomb's coefficient, the fabric's own
  double measured = 0;  ///< tan of the slope, less what the acceleration takes
};

SlideResult slide(const material::Fabric& fabric);

}  // namespace toile::trials
