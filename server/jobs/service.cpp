#include "server/jobs/service.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/base/text.h"
#include "server/jobs/input.h"
#include "server/jobs/recovery.h"
#include "server/jobs/render_worker.h"
#include "server/jobs/row_edits.h"
#include "server/jobs/row_progress.h"
#include "server/jobs/runner.h"
#include "server/jobs/table.h"
#include "server/jobs/transition.h"
#include "server/jobs/worker_pool.h"

namespace toile::jobs {
namespace {

/// How often this process looks whether others have changed anything.
constexpr auto kLookRound = std::chrono::milliseconds(200);
/// How often an end is offered to a store that is busy, which waits for some seconds each time.
constexpr int kMostTries = 3;
/// After the store has refused a claim a worker waits: a full disk is not emptied in a millisecond.
constexpr auto kStorePause = std::chrono::seconds(1);

class QueueingJobService final : public JobService {
 public:
  QueueingJobService(documents::Documents& documents, Publisher& publisher,
                     const JobServiceSettings& settings, const Log& log)
      : documents_(documents),
        store_(documents.store()),
        publisher_(publisher),
        settings_(settings),
        log_(log),
        table_(store_, publisher) {}
  ~QueueingJobService() override { stop(); }

  Status start() override;
  void stop() override;
  Result<store::Made<store::JobRow>> submit(const store::RequestContext& context,
                                            const std::string& project_id, const std::string& idempotency_key,
                                            const JobWish& wish) override;
  Result<store::Made<store::JobRow>> retry(const store::RequestContext& context, const std::string& id,
                                           const std::string& idempotency_key) override;
  Result<store::JobRow> pause(const store::RequestContext& context, const std::string& id) override;
  Result<store::JobRow> resume(const store::RequestContext& context, const std::string& id) override;
  Result<store::JobRow> cancel(const store::RequestContext& context, const std::string& id) override;
  Status remove(const store::RequestContext& context, const std::string& id) override;
  Result<JobProgress> progress(const store::RequestContext& context, const std::string& id) override;
  Counts counts() const override { return table_.counts(); }

 private:
  using Changing = JobTable::Changing;

  Result<store::JobRow> on_request(const store::RequestContext& context, const std::string& id,
                                   JobEvent event, const RowEdit& edit);
  Error refusal(const store::RequestContext& context, const std::string& id, JobEvent event);
  Status check_parking(const Changing& changing, const LiveJob& job) const;
  Status check_queue() const;
  Result<store::Made<store::JobRow>> queue(const store::RequestContext& context, store::JobRow row,
                                           const std::string& idempotency_key, bool anew);
  std::optional<store::JobRow> answered(const Changing& changing, const store::RequestContext& context,
                                        const store::JobRow& job);

  Status take_up_all();
  Status take_over(const Changing& changing, bool own);
  void meet(const Changing& changing, const store::Store::OwnedJob& found);
  void meet_again(const Changing& changing, const LiveJobPtr& job, const store::JobRow& row);
  void refresh(const Changing& changing, const LiveJobPtr& job);
  void look_round();
  void beat();
  void keep_company(const std::stop_token& stop);
  store::RequestContext context_of(const store::Store::OwnedJob& found) const;
  void forget_checkpoint(const LiveJob& job);
  void give_back_all();
  void give_back(const Changing& changing, LiveJob& job, std::unique_ptr<JobRun>& run);
  void give_away(const Changing& changing, LiveJob& job, std::unique_ptr<JobRun>& run);

  bool work_once(WorkerKind kind);
  LiveJobPtr claim(WorkerKind kind);
  Status claim(const Changing& changing, const LiveJobPtr& job);
  void forget_results(const LiveJob& job);
  void come_further(const LiveJobPtr& job);
  Status keep_draped(const LiveJobPtr& job, const RunEnd& end);
  void let_go(const LiveJobPtr& job, const std::optional<RunEnd>& run_end);
  void end(const Changing& changing, const LiveJobPtr& job, const RunEnd& run_end);

  documents::Documents& documents_;
  store::Store& store_;
  Publisher& publisher_;
  const JobServiceSettings settings_;
  const Log log_;
  JobTable table_;

  std::mutex lifecycle_mutex_;  ///< start and stop; before the table's locks
  std::unique_ptr<RenderWorker> renderer_;
  std::unique_ptr<WorkerPool> pool_, express_;
  std::mutex company_mutex_;
  std::condition_variable_any company_bell_;
  std::jthread company_;  ///< keeps leases and looks what other processes do
};

// --- What people ask for ----------------------------------------------------------------------------------

/// Why a job that is not in the table, or in a closed one, cannot change.
Error QueueingJobService::refusal(const store::RequestContext& context, const std::string& id,
                                  JobEvent event) {
  const store::JobRow row = TRY(store_.job(context, id));
  TRY(next_state(row.state, event));
  return {"jobs.stopped", "the server takes no jobs up just now; try again when it has started", "",
          ErrorKind::kUnavailable};
}

Status QueueingJobService::check_parking(const Changing& changing, const LiveJob& job) const {
  if (job.state != store::JobState::kRunning || !job.is_here()) return {};  // takes no memory
  if (table_.begun(changing) < settings_.workers + settings_.max_parked) return {};
  return Error{"jobs.too_many_paused",
               "as many drapes lie paused in memory as there is room for; resume or cancel one first", "",
               ErrorKind::kTooMany};
}

Result<store::JobRow> QueueingJobService::on_request(const store::RequestContext& context,
                                                     const std::string& id, JobEvent event,
                                                     const RowEdit& edit) {
  std::unique_ptr<JobRun> run;  // freed after the lock
  const Changing changing = table_.changing();
  const LiveJobPtr job = table_.find(context, id);
  if (!job || !table_.is_open(changing)) return refusal(context, id, event);
  if (event == JobEvent::kPause) {
    TRY(check_parking(changing, *job));
  }
  const bool interrupted = event == JobEvent::kPause && job->state == store::JobState::kRunning;
  TRY(table_.change(changing, *job, event, interrupted ? RowEdit(uncount) : edit, By::kRequest));
  context.log.info("job changed", {{"job", id}, {"state", std::string(store::name_of(job->state))}});
  if (job->held) return job->row;  // the worker tells when it lets go
  if (event == JobEvent::kPause && job->run) job->run->keep_where_it_stands();
  table_.announce(changing, *job);
  if (store::is_final(job->state)) {
    forget_checkpoint(*job);
    run = table_.remove(changing, job);
  }
  return job->row;
}

Result<store::JobRow> QueueingJobService::pause(const store::RequestContext& context, const std::string& id) {
  return on_request(context, id, JobEvent::kPause, {});
}

Result<store::JobRow> QueueingJobService::resume(const store::RequestContext& context,
                                                 const std::string& id) {
  return on_request(context, id, JobEvent::kResume, {});
}

Result<store::JobRow> QueueingJobService::cancel(const store::RequestContext& context,
                                                 const std::string& id) {
  return on_request(context, id, JobEvent::kCancel, cancelled());
}

Status QueueingJobService::check_queue() const {
  const Counts now = table_.counts();
  if (now.queued + now.paused < settings_.max_queued) return {};  // what is paused comes back
  return Error{"jobs.queue_full", "the queue is full; try again when some drapes have ended", "",
               ErrorKind::kTooMany};
}

Result<store::Made<store::JobRow>> QueueingJobService::submit(const store::RequestContext& context,
                                                              const std::string& project_id,
                                                              const std::string& idempotency_key,
                                                              const JobWish& wish) {
  std::optional<store::JobRow> before = TRY(store_.job_of_key(context, idempotency_key));
  if (before && before->project_id == project_id) {
    return store::Made<store::JobRow>{without_document(std::move(*before)), false};
  }
  TRY(check_queue());
  store::JobRow row = TRY(row_of_drape(documents_, context, project_id, settings_.limits, wish.from));
  row.priority = wish.priority;
  return queue(context, std::move(row), idempotency_key, wish.anew);
}

Result<store::Made<store::JobRow>> QueueingJobService::retry(const store::RequestContext& context,
                                                             const std::string& id,
                                                             const std::string& idempotency_key) {
  const store::JobRow before = TRY(store_.job(context, id));
  if (!store::is_final(before.state)) {
    return Error{"jobs.state",
                 "a job that is " + std::string(store::name_of(before.state)) +
                     " cannot be tried again; it has not ended",
                 "", ErrorKind::kConflict};
  }
  store::JobRow row;
  row.project_id = before.project_id;
  row.project_revision = before.project_revision;
  row.name = before.name;
  row.document = before.document;
  row.files = before.files;
  row.priority = before.priority;
  return queue(context, std::move(row), idempotency_key, true);
}

/// `anew`: whatever equal ones there are.
Result<store::Made<store::JobRow>> QueueingJobService::queue(const store::RequestContext& context,
                                                             store::JobRow row,
                                                             const std::string& idempotency_key, bool anew) {
  row.input = input_of(row, settings_.engine, settings_.still_width, settings_.still_height);
  const Changing changing = table_.changing();
  TRY(check_queue());  // others came while the document was read
  const store::Made<store::JobRow> made = TRY(store_.create_job(context, std::move(row), idempotency_key));
  if (made.anew) {
    std::optional<store::JobRow> ended = anew ? std::nullopt : answered(changing, context, made);
    if (ended) return store::Made<store::JobRow>{std::move(*ended), true};
    const LiveJobPtr job = table_.insert(changing, context, made);
    if (job) table_.announce(changing, *job);
    context.log.info("job queued", {{"job", made.id}, {"project", made.project_id}});
  }
  return store::Made<store::JobRow>{without_document(made), made.anew};
}

/// The job as it has ended already, when an equal one has. Where anything is amiss with that one it is draped
/// as any other.
std::optional<store::JobRow> QueueingJobService::answered(const Changing& changing,
                                                          const store::RequestContext& context,
                                                          const store::JobRow& job) {
  const Result<std::optional<store::JobRow>> equal = store_.succeeded_job_of_input(context, job.input);
  if (!equal || !*equal || !(*equal)->notes.empty()) return std::nullopt;
  const Status shared = store_.share_results(context, (*equal)->id, job.id);
  if (!shared) {
    context.log.warn("an equal job does not answer", shared.error());
    return std::nullopt;
  }
  const Result<store::JobRow> kept = store_.change_job(context, job.id, [&](store::JobRow& row) -> Status {
    TRY(next_state(row.state, JobEvent::kFinish));
    if (!row.lease.holder.empty()) return store::lease_lost();  // a worker was quicker
    const RowEdit answer = answered_by(**equal);
    answer(row);
    return {};
  });
  if (!kept) {
    context.log.warn("an equal job does not answer", kept.error());
    return std::nullopt;
  }
  table_.count_answered(changing);
  context.log.info("job answered by an equal one", {{"job", job.id}, {"equal", (*equal)->id}});
  return without_document(*kept);
}

Status QueueingJobService::remove(const store::RequestContext& context, const std::string& id) {
  const Changing changing = table_.changing();
  const store::JobRow row = TRY(store_.job(context, id));
  if (const LiveJobPtr job = table_.find(context, id); job && !job->held) meet_again(changing, job, row);
  if (!store::is_final(row.state) || table_.find(context, id)) {  // a worker may still have it
    return Error{"jobs.state",
                 "a job that is " + std::string(store::name_of(row.state)) +
                     " cannot be removed; cancel it first and wait until it has ended",
                 "", ErrorKind::kConflict};
  }
  return store_.remove_job(context, id);
}

Result<JobProgress> QueueingJobService::progress(const store::RequestContext& context,
                                                 const std::string& id) {
  if (const LiveJobPtr job = table_.find(context, id)) return table_.progress(*job);
  const store::JobRow row = TRY(store_.job(context, id));
  return progress_of_row(row);
}

// --- Start and stop ---------------------------------------------------------------------------------------

Status QueueingJobService::start() {
  const std::lock_guard life(lifecycle_mutex_);
  if (company_.joinable()) return {};
  TRY(take_up_all());
  if (settings_.workers > 0) {
    renderer_ = std::make_unique<RenderWorker>();
    pool_ = std::make_unique<WorkerPool>(settings_.workers, [this] { return work_once(WorkerKind::kAny); });
    express_ =
        std::make_unique<WorkerPool>(settings_.express, [this] { return work_once(WorkerKind::kExpress); });
  }
  company_ = std::jthread([this](const std::stop_token& stop) { keep_company(stop); });
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

void QueueingJobService::keep_company(const std::stop_token& stop) {
  std::int64_t seen = store_.changes_by_others();
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

// --- What workers do --------------------------------------------------------------------------------------

/// Waits for a job; nothing once the service stops.
LiveJobPtr QueueingJobService::claim(WorkerKind kind) {
  while (table_.wait_for_work(kind)) {
    {
      const Changing changing = table_.changing();
      LiveJobPtr job = table_.next_ready(changing, kind);
      if (!job) continue;  // another worker was quicker
      const Status claimed = claim(changing, job);
      if (claimed) return job;
      const ErrorKind kind_of_refusal = claimed.error().kind;
      if (kind_of_refusal == ErrorKind::kConflict || kind_of_refusal == ErrorKind::kStale) {
        refresh(changing, job);  // another process was quicker
        continue;
      }
      job->context.log.warn("job not claimed", claimed.error());
    }
    table_.pause(kStorePause);
  }
  return nullptr;
}

Status QueueingJobService::claim(const Changing& changing, const LiveJobPtr& held) {
  LiveJob& job = *held;
  if (job.state == store::JobState::kRunning) {  // it had made room
    table_.hand_out(changing, job, {});
    return {};
  }
  const auto lease =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(settings_.lease_s));
  TRY(table_.claim(changing, job, lease, [&](store::JobRow& row) {
    if (!is_of_engine(row.input, settings_.engine)) row.input.clear();  // it answers for no other's drape
  }));
  table_.hand_out(changing, job, [&](std::uint32_t epoch) {
    const RunPlace place{&documents_,
                         &publisher_,
                         renderer_.get(),
                         settings_.stream_interval,
                         std::chrono::duration<double>(settings_.checkpoint_every_s),
                         settings_.still_width,
                         settings_.still_height,
                         settings_.limits};
    return std::make_unique<JobRun>(place, job.context, job.id, epoch);
  });
  table_.announce(changing, job);
  job.context.log.info("job claimed", {{"attempt", std::to_string(job.row.attempt)}});
  return {};
}

bool QueueingJobService::work_once(WorkerKind kind) {
  const LiveJobPtr job = claim(kind);
  if (!job) return false;
  RunControl control;
  control.interrupt = job->interrupt.get();
  // A stop waits a while for pictures of a finished drape; a person who paused or cancelled does not.
  control.abandon = [&] {
    return table_.state(*job) != store::JobState::kRunning || table_.is_out_of_patience();
  };
  control.worth_keeping = [&] { return !store::is_final(table_.state(*job)); };
  control.make_room = [&] { return table_.is_to_make_room(*job, settings_.workers + settings_.max_parked); };
  control.on_progress = [&](const JobProgress& progress) { table_.hear(*job, progress); };
  control.on_kept = [&] { come_further(job); };
  control.on_worked = [&](std::string_view phase, double seconds) { table_.charge(*job, phase, seconds); };
  control.on_draped = [&](const RunEnd& end) { return keep_draped(job, end); };
  let_go(job, job->run->go_on(control));
  return true;
}

/// A job that was suspected of a crash is past where it may have been; when there are others it makes room,
/// so that each has its turn alone.
void QueueingJobService::come_further(const LiveJobPtr& job) {
  if (!job->suspect) return;  // only whoever holds it, and that is this worker, clears it
  const Changing changing = table_.changing();
  const bool others = table_.clear(changing, *job);
  if (!others || job->state != store::JobState::kRunning) return;
  const Status requeued = table_.change(changing, *job, JobEvent::kRequeue, uncount);
  if (!requeued) job->context.log.warn("job makes no room for another", requeued.error());
}

Status QueueingJobService::keep_draped(const LiveJobPtr& job, const RunEnd& end) {
  const Changing changing = table_.changing();
  if (job->state != store::JobState::kRunning)
    return Error{"jobs.state", "the job is not running any more", "", ErrorKind::kCancelled};
  return table_.change(changing, *job, JobEvent::kDraped, draped(end));
}

void QueueingJobService::let_go(const LiveJobPtr& job, const std::optional<RunEnd>& run_end) {
  std::unique_ptr<JobRun> run;  // freed after the lock
  bool unnamed_results = table_.state(*job) == store::JobState::kCancelled;
  if (unnamed_results) forget_results(*job);  // before anybody is told that it has ended
  {
    const Changing changing = table_.changing();
    table_.take_back(changing, *job);
    if (run_end && job->is_here()) end(changing, job, *run_end);
    if (!job->is_here()) run = table_.drop_run(changing, *job);
    if (store::is_final(job->state)) {
      job->context.log.info("job ended", {{"state", std::string(store::name_of(job->state))},
                                          {"reason", job->row.reason_code},
                                          {"worked_s", fixed_text(table_.worked(*job), 3)}});
      forget_checkpoint(*job);
      unnamed_results = !unnamed_results && job->row.results.empty();
      table_.announce(changing, *job);
      std::unique_ptr<JobRun> last = table_.remove(changing, job);
      if (last) run = std::move(last);
    } else if (!job->is_here()) {
      unnamed_results = false;  // whoever has it now tells
    } else if (job->wanted_away) {
      give_away(changing, *job, run);
    } else if (table_.is_open(changing)) {  // else it is told when it has been given back
      table_.announce(changing, *job);
      if (job->state == store::JobState::kRunning) table_.make_wait(changing, *job);
    }
  }
  if (unnamed_results) forget_results(*job);
}

/// Files that were kept before a cancel came, or before the disk was full. The store's next start removes
/// what stays.
void QueueingJobService::forget_results(const LiveJob& job) {
  const Status forgotten = store_.remove_results(job.context, job.id);
  if (!forgotten) job.context.log.warn("results not removed", forgotten.error());
}

void QueueingJobService::end(const Changing& changing, const LiveJobPtr& job, const RunEnd& run_end) {
  if (store::is_final(job->state)) return;  // cancelled before: the end comes too late
  const JobEvent event = run_end.succeeded ? JobEvent::kFinish : JobEvent::kFail;
  Status kept = table_.change(changing, *job, event, ended(run_end));
  for (int again = 0; !kept && kept.error().kind == ErrorKind::kUnavailable && again < kMostTries; ++again)
    kept = table_.change(changing, *job, event, ended(run_end));  // another process had the database
  if (kept) return;
  const Error refusal = kept.error();  // of the store; it may still take the few words of a failure
  job->context.log.warn("job's end not kept", refusal);
  const bool lost = refusal.kind == ErrorKind::kStale || refusal.kind == ErrorKind::kConflict;
  if (lost) return refresh(changing, job);  // another process has it, or has ended it
  kept = table_.change(changing, *job, JobEvent::kFail,
                       with_reason(refusal.code, refusal.message, refusal.where));
  if (kept) return;
  job->context.log.error("job's failure not kept", {{"code", kept.error().code}});
  table_.fail_in_memory(changing, *job);
}

}  // namespace

std::unique_ptr<JobService> make_job_service(documents::Documents& documents, Publisher& publisher,
                                             const JobServiceSettings& settings, const Log& log) {
  return std::make_unique<QueueingJobService>(documents, publisher, settings, log);
}

}  // namespace toile::jobs
