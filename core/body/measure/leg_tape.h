#pragma once

#include "core/body/measure/measures.h"
#include "core/body/measure/trunk_levels.h"

namespace toile::measure {

/// Takes thigh and calf of the left leg, the one on +x. `measures` has the crotch already.
void measure_leg(const TrunkLevels& levels, BodyMeasures& measures);

}  // namespace toile::measure
