#pragma once
// Where the cloth is stretched beyond what its fabric's limits leave it.

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/preflight/finding.h"

namespace toile::analysis {

/// What a direction of a fabric with both limits may stretch. `along`: a unit vector, x along the weft, y
/// along the warp. Shear is not reckoned with: a bias edge that it lengthens counts as stretched.
double stretch_limit(const material::Fabric& fabric, Vec2 along);

/// Findings "strain.over_limit", the worst first: edges of triangles stretched by two percent more than
/// their fabric's limit along them, those of a piece within ten centimetres of its worst one in one finding.
/// Fabrics without limits along warp and weft are not looked at.
preflight::Findings find_over_limit(const drape::DrapeInput& input, const drape::DrapeResult& result);

}  // namespace toile::analysis
