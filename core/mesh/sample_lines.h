#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/mesh/resample.h"
#include "core/pattern/pattern.h"

namespace toile::mesh {

/// The panels' inner lines as points about `particle_distance` (m) apart: [panel][line][point], m. A line
/// that ends within a quarter of that distance of its panel's outline ends on it, in one of the outline's
/// points: the nearest that is no corner is moved along the outline to where the line ends, and so is its
/// partner across a seam, in proportion. Where none can be moved (a corner, or a point that another line has
/// taken) the line's end goes to the nearest point of the outline. A line that is only drawn has no points.
///
/// Error: "mesh.too_many_particles".
Result<std::vector<std::vector<std::vector<Vec2>>>> sample_lines(const pattern::Pattern& pattern,
                                                                 double particle_distance,
                                                                 SampledPattern& sampled);

}  // namespace toile::mesh
