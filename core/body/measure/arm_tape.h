#pragma once

#include "core/body/measure/measures.h"

namespace toile::measure {

/// Takes what the tape reads along the left arm of a standing body of the given stature (m): shoulder width,
/// arm length, upper arm, wrist; and finds shoulder, wrist and hand. `measures` has the points of the trunk
/// already (middle, armpit, crotch, nape). What is not to be found stays untaken.
void measure_arm(const geometry::TriangleMesh& mesh, double stature, BodyMeasures& measures);

}  // namespace toile::measure
