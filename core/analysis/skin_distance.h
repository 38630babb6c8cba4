#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/body/body.h"

namespace toile::analysis {

/// m from each position to the nearest surface of a body, at most `most`; `most` where there is no body.
std::vector<double> skin_distances(std::span<const body::Body> bodies, std::span<const Vec3> positions,
                                   double most);

}  // namespace toile::analysis
