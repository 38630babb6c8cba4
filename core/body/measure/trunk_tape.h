#pragma once

#include "core/base/result.h"
#include "core/body/measure/measures.h"
#include "core/body/measure/trunk_levels.h"

namespace toile::measure {

/// Takes hip, waist, bust and underbust, and notes their heights. `measures` has armpit, crotch and nape
/// already. Error: "body.not_a_body" where armpits, waist and chest are not above one another.
Status measure_trunk(const TrunkLevels& levels, BodyMeasures& measures);

}  // namespace toile::measure
