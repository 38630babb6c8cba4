#pragma once
// Jobs as the HTTP service and the page see them. Owns the queue and the worker threads.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/log.h"
#include "core/base/result.h"
#include "server/documents/documents.h"
#include "server/jobs/figures.h"
#include "server/jobs/limits.h"
#include "server/jobs/publisher.h"
#include "server/jobs/sweeps.h"
#include "server/jobs/touch_inbox.h"
#include "server/jobs/wish.h"
#include "server/store/store.h"

namespace toile::jobs {

struct JobServiceSettings {
  int workers = 2;        ///< threads that drape; 0: other processes do
  int express = 1;        ///< and threads that only begin interactive drapes for which none of those has time
  int max_queued = 1000;  ///< waiting or paused; beyond it submissions are refused (jobs.queue_full)
  /// Drapes that lie in memory beside those that workers have, paused or waiting for their next turn. Where
  /// more are begun, a drape that makes room leaves memory and is taken up again from its checkpoint; where
  /// so many are paused, another pause is refused (jobs.too_many_paused).
  int max_parked = 16;
  int stream_interval = 50;                     ///< substeps between streamed frames
  double checkpoint_every_s = 5;                ///< by the clock; what a crash can cost
  double lease_s = 15;                          ///< how long a job waits for a holder who is not heard of
  double heartbeat_s = 5;                       ///< how often this process is
  int still_width = 1024, still_height = 1280;  ///< pixels
  JobLimits limits;                             ///< of each job
  /// What tells this engine from any other: a drape of an input that it has draped is answered with the
  /// results of then. Empty: each is draped.
  std::string engine;
};

/// Workers drape in slices. Between two a drape makes room for an interactive one, and for one of an owner
/// who has had less of the workers' time (turn.h); it then waits in memory, or aside as its checkpoint. How
/// it is cut changes no byte. All calls are thread-safe. The rows that they give back are without the
/// document.
class JobService {
 public:
  virtual ~JobService() = default;

  /// Takes up what is queued, running or paused, and starts the workers. Other processes may work on jobs of
  /// the same store: each job has one holder at a time, who is known by the number of its lease, and what a
  /// process leaves that is no more, or is not heard of for that long, the others take over. What is paused
  /// stays so. What had begun goes on from its newest checkpoint, and ends in the same bytes as if nothing
  /// had happened. What a crash may be put down to runs alone until it has come further; what has crashed
  /// alone three times is not tried again but failed (jobs.attempts), or ends without pictures when it has
  /// been draped (recovery.h). Twice is safe, and so is a start after a stop. Errors: those of the store.
  virtual Status start() = 0;
  /// Claims nothing more, lets running drapes go back to the queue, joins the threads. A drape of which only
  /// pictures and results are missing is brought to its end. Twice is safe.
  virtual void stop() = 0;

  /// Queues a drape of the project as it is now; or, where this owner's project has been draped by this
  /// engine in this state with all that belongs to it, makes a job that has ended with the same results.
  /// Durable when it returns; while the service does not run, the next start takes it up. Under a key that
  /// made a job of this project before, gives back that job, whatever has become of the project or the queue
  /// since. Errors: store.not_found, store.idempotency_mismatch when the key was for another project,
  /// store.idempotency_key, jobs.queue_full, limits.particles, quota.bytes, quota.jobs, and whatever reading
  /// the document gives (json.*, project.*, dxf.*, …), so that bad input is told at once.
  virtual Result<store::Made<store::JobRow>> submit(const store::RequestContext& context,
                                                    const std::string& project_id,
                                                    const std::string& idempotency_key,
                                                    const JobWish& wish = {}) = 0;
  /// Queues a drape of what a job that has ended draped, its document and files as they were then, with its
  /// tags; that of a sweep's cell takes its place there. Under a key as submit(). Errors: store.not_found,
  /// jobs.state, store.idempotency_mismatch, store.idempotency_key, jobs.queue_full, quota.bytes, quota.jobs.
  virtual Result<store::Made<store::JobRow>> retry(const store::RequestContext& context,
                                                   const std::string& id,
                                                   const std::string& idempotency_key) = 0;
  /// Queues a drape for each cell of a sweep (swept_jobs()), all of them or none; those of an equal input are
  /// answered as submit() does. Under a key that made a sweep of this project before, gives back that one.
  /// Errors: those of swept_jobs(), store.idempotency_mismatch, store.idempotency_key, jobs.queue_full,
  /// quota.bytes, quota.jobs; jobs.no_sweeps when the store keeps none.
  virtual Result<store::Made<store::SweptJobs>> submit_sweep(const store::RequestContext& context,
                                                             const SweepWish& wish,
                                                             const std::string& idempotency_key) = 0;
  /// The state has changed when these return, durably; a worker that drapes lets go within 50 ms. A paused
  /// drape stays in memory, and resuming puts it at the head of the queue. Errors: store.not_found;
  /// jobs.state when the job's state does not allow it; jobs.stopped while the service does not run;
  /// jobs.too_many_paused.
  virtual Result<store::JobRow> pause(const store::RequestContext& context, const std::string& id) = 0;
  virtual Result<store::JobRow> resume(const store::RequestContext& context, const std::string& id) = 0;
  virtual Result<store::JobRow> cancel(const store::RequestContext& context, const std::string& id) = 0;

  /// Lets a paused drape go on to its next streamed frame, or its end, and pauses it again. Gives back the
  /// job as it runs. Errors: as resume().
  virtual Result<store::JobRow> step(const store::RequestContext& context, const std::string& id) = 0;
  /// Goes on with the project as it is by now: a new job, from how the garment of this one hangs (or from the
  /// pieces, where it does not hang yet), in whose place it comes. This one ends as cancelled, with code
  /// "superseded" and the new job's id as its place; where it has come to its end and is only being drawn, it
  /// stays and succeeds. Under a key as submit(). Errors: those of submit();
  /// jobs.state where the job neither waits, runs nor is paused; live.elsewhere while another process drapes
  /// it; jobs.no_shape where its worker does not answer.
  virtual Result<store::Made<store::JobRow>> go_on(const store::RequestContext& context,
                                                   const std::string& id,
                                                   const std::string& idempotency_key) = 0;
  /// A hand on the cloth of a drape that runs or is paused; the worker takes it up within 50 ms. Errors:
  /// store.not_found; jobs.state when it neither runs nor is paused; live.elsewhere while another process
  /// drapes it; those of TouchInbox::put. What the cloth refuses is told to LiveTouch::refused.
  virtual Status touch(const store::RequestContext& context, const std::string& id, LiveTouch touch) = 0;

  /// Removes a job that has ended, with its results. Errors: store.not_found; jobs.state when it has not
  /// ended; those of the store.
  virtual Status remove(const store::RequestContext& context, const std::string& id) = 0;

  /// What a job is doing now; from the store's row when it is not under way. Error: store.not_found.
  virtual Result<JobProgress> progress(const store::RequestContext& context, const std::string& id) = 0;

  struct Counts {
    int queued = 0, running = 0, paused = 0;
    int in_memory = 0;                                   ///< begun, and not put aside
    long long succeeded = 0, failed = 0, cancelled = 0;  ///< since the service was made
    long long steps = 0;                                 ///< substeps since then
    long long answered = 0;                              ///< of the succeeded, with results of before
    double oldest_queued_s = 0;                          ///< age of the job that waits longest
    Histogram wait, run;                   ///< from submission to the first claim; from there to the end
    std::map<std::string, double> work_s;  ///< processor time by phase; of "stills" time by the clock
  };
  virtual Counts counts() const = 0;
};

/// `documents`, `publisher` and the log's sink must outlive the service. The log is for what the service does
/// by itself; what is done for a request goes to the log of its context.
std::unique_ptr<JobService> make_job_service(documents::Documents& documents, Publisher& publisher,
                                             const JobServiceSettings& settings, const Log& log = {});

}  // namespace toile::jobs
