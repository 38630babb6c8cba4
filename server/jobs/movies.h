#pragma once
// Movies of jobs that have ended, made on demand.

#include <string>

#include "server/jobs/on_demand.h"
#include "server/movie/make_movie.h"

namespace toile::jobs {

class Movies : public OnDemand {
 public:
  explicit Movies(store::Store& store, OrderLimits limits = {});

  /// Errors: movie.settings, movie.kind, movie.format; those of OnDemand.
  Result<Order> ask(const store::RequestContext& context, const std::string& job_id,
                    const movie::MovieSettings& settings);
};

/// The name of the result: "drape-720x900-25.mp4".
std::string movie_name(const movie::MovieSettings& settings);

}  // namespace toile::jobs
