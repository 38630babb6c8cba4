#pragma once
// Jobs as the HTTP service and the page see them. Owns the queue and the worker threads.

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/jobs/publisher.h"
#include "server/store/store.h"

namespace toile {

struct JobServiceSettings {
  int workers = 2;             ///< threads that drape
  int max_queued = 1000;       ///< beyond it submissions are refused (jobs.queue_full)
  int stream_interval = 50;    ///< substeps between streamed frames
};

class JobService {
 public:
  virtual ~JobService() = default;

  /// Takes up what was left queued or running, and starts the workers.
  virtual Status start() = 0;
  /// Claims nothing more, lets running drapes go back to the queue, joins the threads. Twice is safe.
  virtual void stop() = 0;

  /// Queues a drape of the project as it is now. Durable when it returns. Errors: store.not_found, jobs.queue_full,
  /// and whatever reading the document gives (json.*, project.*, dxf.*, …), so that bad input is told at once.
  virtual Result<JobRow> submit(const OwnerId& owner, const std::string& project_id,
                                const std::string& idempotency_key) = 0;
  /// Errors: store.not_found; jobs.state when the job's state does not allow it.
  virtual Result<JobRow> pause(const OwnerId& owner, const std::string& id) = 0;
  virtual Result<JobRow> resume(const OwnerId& owner, const std::string& id) = 0;
  virtual Result<JobRow> cancel(const OwnerId& owner, const std::string& id) = 0;

  /// What a job is doing now; from the store's row when it is not running.
  virtual Result<JobProgress> progress(const OwnerId& owner, const std::string& id) = 0;

  struct Counts {
    int queued = 0, running = 0, paused = 0;
    long long succeeded = 0, failed = 0, cancelled = 0;  ///< since the start
    long long steps = 0;                                 ///< substeps since the start
  };
  virtual Counts counts() const = 0;
};

std::unique_ptr<JobService> make_job_service(Store& store, Publisher& publisher, const JobServiceSettings& settings);

}  // namespace toile
