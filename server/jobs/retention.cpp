#include "server/jobs/retention.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/row_edits.h"

namespace toile::jobs {
namespace {

/// A page of jobs at a time, so that requests come in between.
constexpr int kAtOnce = 100;

std::int64_t days_before(std::int64_t now_ms, double days) {
  constexpr double kDayMs = 24.0 * 3600 * 1000;
  return now_ms - static_cast<std::int64_t>(days * kDayMs);
}

/// The store's own doing for somebody.
store::RequestContext context_of(const store::OwnedId& thing, const Log& log) {
  return store::RequestContext(thing.owner, "", log);
}

int remove_jobs(store::Store& store, JobService& jobs, std::int64_t before_ms, const Log& log) {
  int removed = 0;
  for (;;) {
    const Result<std::vector<store::OwnedId>> old = store.jobs_ended_before(before_ms, kAtOnce);
    if (!old) log.warn("old jobs not found", old.error());
    if (!old || old->empty()) return removed;
    const int before = removed;
    for (const store::OwnedId& job : *old) {
      const Status gone = jobs.remove(context_of(job, log), job.id);
      if (!gone) log.warn("old job not removed", gone.error());
      removed += gone ? 1 : 0;
    }
    if (removed == before) return removed;  // those that stay would be named again and again
  }
}

int remove_uploads(store::Store& store, std::int64_t before_ms, const Log& log) {
  const Result<std::vector<store::OwnedId>> old = store.unused_assets(before_ms);
  if (!old) log.warn("old uploads not found", old.error());
  if (!old) return 0;
  int removed = 0;
  for (const store::OwnedId& asset : *old) {
    const Status gone = store.remove_asset(context_of(asset, log), asset.id);
    if (!gone && gone.error().kind != ErrorKind::kConflict) log.warn("old upload not removed", gone.error());
    removed += gone ? 1 : 0;
  }
  return removed;
}

}  // namespace

Removed remove_old(store::Store& store, JobService& jobs, const RetentionSettings& settings,
                   std::int64_t now_ms, const Log& log) {
  Removed removed;
  if (settings.jobs_days > 0)
    removed.jobs = remove_jobs(store, jobs, days_before(now_ms, settings.jobs_days), log);
  if (settings.uploads_days > 0)
    removed.uploads = remove_uploads(store, days_before(now_ms, settings.uploads_days), log);
  if (removed.jobs + removed.uploads > 0) {
    log.info("removed what was kept long enough",
             {{"jobs", std::to_string(removed.jobs)}, {"uploads", std::to_string(removed.uploads)}});
  }
  return removed;
}

class Retention::Thread {
 public:
  Thread(store::Store& store, JobService& jobs, const RetentionSettings& settings, const Log& log)
      : thread_([&store, &jobs, settings, log, this](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            remove_old(store, jobs, settings, unix_ms(), log);
            std::unique_lock lock(mutex_);
            bell_.wait_for(lock, stop, std::chrono::hours(1), [] { return false; });
          }
        }) {}

 private:
  std::mutex mutex_;
  std::condition_variable_any bell_;
  std::jthread thread_;  // last: it uses the others
};

Retention::Retention(store::Store& store, JobService& jobs, const RetentionSettings& settings,
                     const Log& log) {
  if (settings.jobs_days > 0 || settings.uploads_days > 0)
    thread_ = std::make_unique<Thread>(store, jobs, settings, log);
}

Retention::~Retention() = default;

}  // namespace toile::jobs
