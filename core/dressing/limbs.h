#pragma once
// What lies around a limb.

#include "core/base/types.h"
#include "core/body/measure/figure.h"

namespace toile::dressing {

/// Whether cloth at p (m) is around an arm or a leg: below the crotch, or along an arm from where it has left
/// the trunk on, no farther from its middle line than a wide sleeve.
bool is_around_limb(const measure::BodyFigure& figure, Vec3 p);

}  // namespace toile::dressing
