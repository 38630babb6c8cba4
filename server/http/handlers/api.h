#pragma once
// The routes of the service, resource by resource. A handler parses, calls and answers; it may block.

#include <atomic>

#include "server/http/metrics.h"
#include "server/http/router.h"
#include "server/jobs/job_service.h"
#include "server/store/store.h"
#include "server/ws/hub.h"

namespace toile {

/// What handlers work with; outlives the router.
struct Api {
  Store& store;
  JobService& jobs;
  const Hub& hub;
  const Metrics& metrics;
  const std::atomic<bool>& ready;  ///< false while the server drains
};

void add_health_routes(Router& router, const Api& api);
void add_asset_routes(Router& router, const Api& api);
void add_project_routes(Router& router, const Api& api);
void add_edit_routes(Router& router, const Api& api);
void add_body_routes(Router& router, const Api& api);
void add_arrangement_routes(Router& router, const Api& api);
void add_job_routes(Router& router, const Api& api);

}  // namespace toile
