#pragma once
// What one job may take.

#include <optional>

#include "core/base/result.h"
#include "core/drape/drape_input.h"

namespace toile::jobs {

/// 0: as much as it wants.
struct JobLimits {
  double work_s = 0;     ///< processor time, over all its starts; without that of its pictures
  long long steps = 0;   ///< substeps
  double particles = 0;  ///< of the whole garment
};

/// Before it is begun. Error: limits.particles, by what its pieces will have about (5 %).
Status check_size(const JobLimits& limits, const drape::DrapeInput& cloth);

/// While it runs. Errors: limits.time, limits.steps.
Status check_work(const JobLimits& limits, double work_s, long long steps);

}  // namespace toile::jobs
