#pragma once
// On whose behalf something is done. Made once, where a request comes in (server/http/identify.h) or where
// the service acts by itself, and handed down to everything that is done for it.

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "core/base/log.h"
#include "server/store/scopes.h"

namespace toile::store {

using OwnerId = std::string;
struct LinkRow;

struct RequestContext {
  OwnerId owner;                  ///< what is looked up, made and changed is theirs
  std::string request_id;         ///< empty where no request asked
  Scopes scopes = Scopes::all();  ///< what whoever asks may do
  std::string key;                ///< hash of the key or the link by which they are known; empty: by none
  /// The share link by which somebody looks on who is nobody here; null: none.
  std::shared_ptr<const LinkRow> link{};
  /// Becomes true once nobody waits for what is done, or it takes too long: what takes long looks at it. Null
  /// where nothing can be given up.
  std::shared_ptr<const std::atomic<bool>> given_up{};
  /// Number of the lease under which this is done for a job (store.h); 0: nobody's work, but a request.
  std::int64_t lease = 0;
  Log log{};  ///< says request and owner (and, of a drape, the job) with every line

  RequestContext() = default;
  explicit RequestContext(OwnerId whose, std::string request = "", const Log& to = {})
      : owner(std::move(whose)), request_id(std::move(request)), log(to.with("owner", owner)) {
    if (!request_id.empty()) log = log.with("request", request_id);
  }

  bool is_given_up() const { return given_up && given_up->load(std::memory_order_relaxed); }

  /// What is done for a job, also when the request that asked for it has long been answered.
  RequestContext for_job(const std::string& job_id) const {
    RequestContext job = *this;
    job.log = log.with("job", job_id);
    job.given_up = nullptr;
    return job;
  }
};

}  // namespace toile::store
