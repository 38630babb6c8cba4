#include "server/jobs/limits.h"

#include <cmath>
#include <string>

#include "core/mesh/triangulate.h"
#include "core/pattern/curve.h"
#include "core/pattern/pattern.h"

namespace toile::jobs {
namespace {

/// m², without holes.
double area_of(const pattern::Panel& panel) {
  constexpr double kSquareMillimetres = 1e6;
  double area = std::abs(pattern::signed_area(panel.outline));
  for (const pattern::Loop& hole : panel.holes) area -= std::abs(pattern::signed_area(hole));
  return area / kSquareMillimetres;
}

}  // namespace

Status check_size(const JobLimits& limits, const drape::DrapeInput& cloth) {
  if (limits.particles <= 0) return {};
  double particles = 0;
  for (const pattern::Panel& panel : cloth.pattern.panels) {
    const double distance = pattern::spacing_on(panel, cloth.settings.particle_distance);
    particles += mesh::particle_estimate(area_of(panel), distance);
  }
  if (particles <= limits.particles) return {};
  return Error{"limits.particles",
               "the garment would have about " + std::to_string(std::llround(particles)) +
                   " particles, and " + std::to_string(std::llround(limits.particles)) +
                   " are the most here; choose a larger particle distance",
               "/document/settings/particle_distance_mm"};
}

Status check_work(const JobLimits& limits, double work_s, long long steps) {
  if (limits.work_s > 0 && work_s > limits.work_s) {
    return Error{"limits.time",
                 "the drape took more than the " + std::to_string(std::llround(limits.work_s)) +
                     " s of processor time that one may take here; a larger particle distance or a shorter "
                     "max_time_s needs less",
                 ""};
  }
  if (limits.steps > 0 && steps > limits.steps) {
    return Error{"limits.steps",
                 "the drape took more than the " + std::to_string(limits.steps) +
                     " steps that one may take here; a shorter max_time_s needs fewer",
                 ""};
  }
  return {};
}

}  // namespace toile::jobs
