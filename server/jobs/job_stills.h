#pragma once
// Stills of jobs that have ended, from anywhere, made on demand.

#include <string>

#include "server/jobs/on_demand.h"
#include "server/movie/film_still.h"

namespace toile::jobs {

class JobStills : public OnDemand {
 public:
  explicit JobStills(store::Store& store, OrderLimits limits = {.of_job = 40, .side = 4096});

  /// Errors: render.settings, render.camera, map.unknown; those of OnDemand. One whose making fails has those
  /// of movie::take_still.
  Result<Order> ask(const store::RequestContext& context, const std::string& job_id,
                    const movie::StillWish& wish);
};

/// The name of the result: "still-front-1024x1280.png", with a map "still-front-ease-1024x1280.png". An own
/// camera has a number for its place.
std::string still_name(const movie::StillWish& wish);

}  // namespace toile::jobs
