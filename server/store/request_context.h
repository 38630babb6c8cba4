#pragma once
// On whose behalf something is done. Made once, where a request comes in (server/http/identify.h) or where
// the service acts by itself, and handed down to everything that is done for it.

#include <string>
#include <utility>

#include "core/base/log.h"

namespace toile {

using OwnerId = std::string;

struct RequestContext {
  OwnerId owner;           ///< what is looked up, made and changed is theirs
  std::string request_id;  ///< empty where no request asked
  Log log{};               ///< says request and owner (and, of a drape, the job) with every line

  RequestContext() = default;
  explicit RequestContext(OwnerId whose, std::string request = "", const Log& to = {})
      : owner(std::move(whose)), request_id(std::move(request)), log(to.with("owner", owner)) {
    if (!request_id.empty()) log = log.with("request", request_id);
  }

  /// What is done for a job, also when the request that asked for it has long been answered.
  RequestContext for_job(const std::string& job_id) const {
    RequestContext job = *this;
    job.log = log.with("job", job_id);
    return job;
  }
};

}  // namespace toile
