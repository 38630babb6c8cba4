#include <chrono>
#include <cmath>
#include <set>
#include <utility>

#include "server/jobs/queueing_service.h"
#include "server/jobs/row_progress.h"

namespace toile::jobs {

namespace {

/// How often this process looks whether others have changed anything.
constexpr auto kLookRound = std::chrono::milliseconds(200);

}  // namespace

Status QueueingJobService::start() {
  const std::lock_guard life(lifecycle_mutex_);
  if (company_.joinable()) return {};
  const std::int64_t seen = store_.changes_by_others();  // before it is looked: what comes since is news
  TRY(take_up_all());
  if (settings_.workers > 0) {
    renderer_ = std::make_unique<RenderWorker>();
    pool_ = std::make_unique<WorkerPool>(settings_.workers, [this] { return work_once(WorkerKind::kAny); });
    express_ =
        std::make_unique<WorkerPool>(settings_.express, [this] { return work_once(WorkerKind::kExpress); });
  }
  company_ = std::jthread([this, seen](const std::stop_token& stop) { keep_company(stop, seen); });
  return {};
}

Status QueueingJobService::take_up_all() {
  const Changing changing = table_.changing();
  table_.open(changing);
  Status taken = take_over(changing, true);
  Result<std::vector<store::Store::OwnedJob>> found = store_.unfinished_jobs();
  if (taken && !found) taken = found.error();
  if (!taken) {
    table_.close(changing);
    for (const LiveJobPtr& had : table_.all(changing)) table_.remove(changing, had);
    return taken;
  }
  for (const store::Store::OwnedJob& job : *found) meet(changing, job);
  return {};
}

/// Judges what processes have left that are no more; `own`: also what this one has left, at its last stop.
Status QueueingJobService::take_over(const Changing& changing, bool own) {
  const std::vector<store::Store::OwnedJob> left = TRY(store_.take_from_the_gone(unix_ms(), own, judge));
  for (const store::Store::OwnedJob& found : left) {
    context_of(found).log.warn(
        "job taken over from a process that is no more",
        {{"job", found.job.id}, {"state", std::string(store::name_of(found.job.state))}});
    meet(changing, found);
  }
  return {};
}

/// A job as the store has it now.
void QueueingJobService::meet(const Changing& changing, const store::Store::OwnedJob& found) {
  LiveJobPtr job = table_.find(context_of(found), found.job.id);
  if (!job && !store::is_final(found.job.state)) {
    table_.insert(changing, context_of(found), found.job);
    return;
  }
  if (!job) {  // it ends here and now
    store::JobRow before = found.job;
    before.state = store::JobState::kQueued;
    job = table_.insert(changing, context_of(found), before);
  }
  if (job) meet_again(changing, job, found.job);
}

/// Who holds it tells of it, or lets go of what is over.
void QueueingJobService::meet_again(const Changing& changing, const LiveJobPtr& job,
                                    const store::JobRow& row) {
  std::unique_ptr<JobRun> run;
  const bool changed = table_.adopt(changing, *job, row);
  if (job->held) return;
  if (store::is_final(job->state)) {
    forget_checkpoint(*job);
    table_.announce(changing, *job);
    run = table_.remove(changing, job);
  } else if (!job->is_here()) {
    run = table_.drop_run(changing, *job);
    table_.announce(changing, *job);
  } else if (job->wanted_away) {
    give_away(changing, *job, run);
  } else if (changed) {
    table_.announce(changing, *job);
  }
}

/// Of one that the store refuses to be changed.
void QueueingJobService::refresh(const Changing& changing, const LiveJobPtr& job) {
  const Result<store::JobRow> row = store_.job(job->context, job->id);
  if (row) meet_again(changing, job, *row);
  if (row || row.error().kind != ErrorKind::kNotFound) return;
  store::JobRow gone = job->row;  // removed by another process, when it had ended
  gone.state = store::JobState::kCancelled;
  meet_again(changing, job, gone);
}

/// What other processes have made of the jobs.
void QueueingJobService::look_round() {
  const Changing changing = table_.changing();
  const Result<std::vector<store::Store::OwnedJob>> found = store_.unfinished_jobs();
  if (!found) return log_.warn("jobs not looked at", found.error());
  std::set<std::string> there;
  for (const store::Store::OwnedJob& owned : *found) {
    there.insert(owned.job.id);
    meet(changing, owned);
  }
  for (const LiveJobPtr& job : table_.all(changing)) {
    if (!there.contains(job->id)) refresh(changing, job);
  }
}

/// Keeps the leases of this process, with how far its drapes are.
void QueueingJobService::beat() {
  const auto lease =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(settings_.lease_s));
  for (const JobTable::Held& held : table_.held_here()) {
    const Result<store::JobRow> kept =
        store_.change_job(held.context, held.job->id, [&](store::JobRow& row) -> Status {
          if (store::is_final(row.state)) return {};
          row.lease.until_ms = unix_ms() + lease.count();
          row.progress = text_of(held.progress);
          row.worked_ms = std::llround(1000 * held.worked_s);
          row.suspect = held.suspect;
          return {};
        });
    if (kept) continue;
    held.context.log.warn("lease not kept", kept.error());
    if (kept.error().kind != ErrorKind::kStale) continue;
    const Changing changing = table_.changing();
    refresh(changing, held.job);
  }
}

/// `seen`: what changes_by_others() told before the jobs were looked at last.
void QueueingJobService::keep_company(const std::stop_token& stop, std::int64_t seen) {
  const auto pause = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::duration<double>(settings_.heartbeat_s));
  auto next_beat = std::chrono::steady_clock::now() + pause;
  while (!stop.stop_requested()) {
    if (std::chrono::steady_clock::now() >= next_beat) {
      next_beat = std::chrono::steady_clock::now() + pause;
      beat();
      const Changing changing = table_.changing();
      const Status taken = take_over(changing, false);
      if (!taken) log_.warn("jobs of others not taken over", taken.error());
    }
    const std::int64_t now = store_.changes_by_others();
    if (now != seen) look_round();
    seen = now;
    std::unique_lock lock(company_mutex_);
    company_bell_.wait_for(lock, stop, kLookRound, [] { return false; });
  }
}

/// Nobody waits any more for the request that once asked for it.
store::RequestContext QueueingJobService::context_of(const store::Store::OwnedJob& found) const {
  return store::RequestContext(found.owner, "", log_);
}

/// One that cannot be removed now goes when the store is opened next.
void QueueingJobService::forget_checkpoint(const LiveJob& job) {
  const Status forgotten = store_.remove_checkpoint(job.context, job.id);
  if (!forgotten) job.context.log.warn("checkpoint not removed", forgotten.error());
}

void QueueingJobService::stop() {
  const std::lock_guard life(lifecycle_mutex_);
  if (!company_.joinable()) return;
  table_.close(table_.changing());
  pool_.reset();
  express_.reset();
  renderer_.reset();
  company_ = {};
  give_back_all();
}

/// What has not ended goes back to the queue in the store. REQUIRES that no worker runs.
void QueueingJobService::give_back_all() {
  const Changing changing = table_.changing();
  for (const LiveJobPtr& job : table_.all(changing)) {
    std::unique_ptr<JobRun> run;
    give_back(changing, *job, run);
    table_.announce(changing, *job);
    table_.remove(changing, job);
  }
}

/// What is paused stays so, and what has not begun is in the store as it is. What the store will not take is
/// found at the next start as after a crash.
void QueueingJobService::give_back(const Changing& changing, LiveJob& job, std::unique_ptr<JobRun>& run) {
  if (!job.is_here()) return;
  if (job.state != store::JobState::kRunning) return give_away(changing, job, run);
  if (job.run) job.run->keep_where_it_stands();
  const Status given = table_.change(changing, job, JobEvent::kRequeue, [](store::JobRow& row) {
    requeued()(row);
    uncount(row);
    row.lease.holder.clear();
  });
  if (!given) job.context.log.warn("job not given back to the queue", given.error());
}

/// For any process to go on with, from where it stands.
void QueueingJobService::give_away(const Changing& changing, LiveJob& job, std::unique_ptr<JobRun>& run) {
  if (job.run) job.run->keep_where_it_stands();
  const Status given = table_.release(changing, job, run);
  if (!given) job.context.log.warn("lease not given back", given.error());
}

}  // namespace toile::jobs
