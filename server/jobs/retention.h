#pragma once
// Removes what has been kept as long as it was to be kept.

#include <cstdint>
#include <memory>

#include "core/base/log.h"
#include "server/jobs/service.h"
#include "server/store/store.h"

namespace toile::jobs {

/// Days; 0: for ever.
struct RetentionSettings {
  double jobs_days = 0;     ///< of a job that has ended, with all that it left, from its end
  double uploads_days = 0;  ///< of a file that no project and no job names, from its upload
};

struct Removed {
  int jobs = 0, uploads = 0;
};

/// Once. What cannot be removed just now is passed over with a line in the log.
Removed remove_old(store::Store& store, JobService& jobs, const RetentionSettings& settings,
                   std::int64_t now_ms, const Log& log);

/// The same again and again: soon, and then each hour.
class Retention {
 public:
  /// `store` and `jobs` must outlive it.
  Retention(store::Store& store, JobService& jobs, const RetentionSettings& settings, const Log& log);
  ~Retention();
  Retention(const Retention&) = delete;
  Retention& operator=(const Retention&) = delete;

 private:
  class Thread;
  std::unique_ptr<Thread> thread_;
};

}  // namespace toile::jobs
