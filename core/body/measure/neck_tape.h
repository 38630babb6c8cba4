#pragma once

#include "core/body/measure/measures.h"
#include "core/body/measure/trunk_levels.h"

namespace toile::measure {

/// Takes the neck's girth and, down from the nape, the back's length; finds the nape. `measures` has armpit
/// and crotch already. What is not to be found stays untaken.
void measure_neck_and_back(const geometry::TriangleMesh& mesh, const TrunkLevels& levels,
                           BodyMeasures& measures);

}  // namespace toile::measure
