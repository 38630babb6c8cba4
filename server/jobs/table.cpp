#include "server/jobs/table.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "server/jobs/row_progress.h"

namespace toile::jobs {

Status JobTable::change(const Changing&, LiveJob& job, JobEvent event, const RowEdit& edit, By by) {
  store::RequestContext context = job.context;
  if (by == By::kRequest) context.lease = 0;
  return write(job, context, event, [&](store::JobRow& row) -> Status {
    if (edit) edit(row);
    return {};
  });
}

/// What ends has no holder. What this process alone knows of its own work goes along.
Status JobTable::write(LiveJob& job, const store::RequestContext& context, JobEvent event,
                       const store::Store::JobEdit& edit) {
  const double worked_s = worked(job);
  JobTransition next;
  store::JobRow before;
  const store::Store::JobEdit whole = [&](store::JobRow& now) -> Status {
    next = TRY(next_state(now.state, event));
    before = now;
    now.state = next.state;
    if (job.is_here()) {
      now.worked_ms = std::llround(1000 * worked_s);
      now.suspect = job.suspect;
    }
    if (store::is_final(next.state)) {
      now.ended_ms = unix_ms();
      now.lease.holder.clear();
      now.suspect = false;
    }
    return edit(now);
  };
  store::JobRow row = TRY(store_.change_job(context, job.id, whole));
  {
    const std::lock_guard lock(mutex_);
    tally_.changed(event, before, row);
    job.row = without_document(std::move(row));
    job.state = next.state;
    roster_.put(job, next.effects.queue);
    job.waits_since = std::chrono::steady_clock::now();
    if (next.effects.interrupt) job.interrupt->store(true, std::memory_order_relaxed);
    if (next.effects.ends) tally_.ended(job.state);
  }
  bell_.notify_all();
  return {};
}

Status JobTable::claim(const Changing&, LiveJob& job, std::chrono::milliseconds lease, const RowEdit& edit) {
  const bool anew = job.run == nullptr;
  store::RequestContext context = job.context;
  if (anew) context.lease = 0;
  TRY(write(job, context, JobEvent::kClaim, [&](store::JobRow& row) -> Status {
    if (!row.lease.holder.empty() && row.lease.holder != store_.holder())
      return Error{"jobs.taken", "another process works on it", "", ErrorKind::kConflict};
    with_reason("", "")(row);
    if (anew || row.attempt == 0) ++row.attempt;
    if (anew) row.started_ms = unix_ms();
    if (anew) ++row.lease.number;
    if (edit) edit(row);
    row.lease.holder = store_.holder();
    row.lease.until_ms = unix_ms() + lease.count();
    return {};
  }));
  const std::lock_guard lock(mutex_);
  job.context.lease = job.row.lease.number;
  job.wanted_away = false;
  if (anew) job.worked_s = static_cast<double>(job.row.worked_ms) / 1000;
  return {};
}

Status JobTable::tell_work(const Changing&, LiveJob& job) {
  const double worked_s = worked(job);
  const std::string told = text_of(progress(job));
  store::JobRow row = TRY(store_.change_job(job.context, job.id, [&](store::JobRow& now) -> Status {
    now.worked_ms = std::llround(1000 * worked_s);
    now.progress = told;
    return {};
  }));
  const std::lock_guard lock(mutex_);
  job.row = without_document(std::move(row));
  return {};
}

Status JobTable::release(const Changing&, LiveJob& job, std::unique_ptr<JobRun>& run) {
  const double worked_s = worked(job);
  store::JobRow row = TRY(store_.change_job(job.context, job.id, [&](store::JobRow& now) -> Status {
    now.worked_ms = std::llround(1000 * worked_s);
    now.lease.holder.clear();
    return {};
  }));
  {
    const std::lock_guard lock(mutex_);
    run = std::move(job.run);
    job.context.lease = 0;
    job.wanted_away = false;
    job.row = without_document(std::move(row));
    roster_.place(job, false);
  }
  bell_.notify_all();
  return {};
}

bool JobTable::adopt(const Changing&, LiveJob& job, const store::JobRow& row) {
  const bool final = store::is_final(row.state);
  bool changed = false;
  {
    const std::lock_guard lock(mutex_);
    const bool same_lease = row.lease.number == job.context.lease;
    if (job.is_here() && !(same_lease && (final || row.lease.holder == store_.holder()))) {
      job.context.lease = 0;
      job.interrupt->store(true, std::memory_order_relaxed);
    }
    changed = row.state != job.state;
    if (changed && final) tally_.ended(row.state);
    if (changed && job.held) job.interrupt->store(true, std::memory_order_relaxed);
    if (changed && job.is_here()) job.wanted_away = row.state == store::JobState::kPaused;
    job.state = row.state;
    job.row = without_document(row);
    if (!job.is_here()) {
      job.suspect = row.suspect;
      job.worked_s = static_cast<double>(row.worked_ms) / 1000;
      job.progress = progress_of_row(row);
    }
    roster_.place(job, changed);
  }
  bell_.notify_all();
  return changed;
}

std::unique_ptr<JobRun> JobTable::drop_run(const Changing&, LiveJob& job) {
  const std::lock_guard lock(mutex_);
  return std::move(job.run);
}

std::vector<JobTable::Held> JobTable::held_here() const {
  const std::lock_guard lock(mutex_);
  std::vector<Held> held;
  for (const LiveJobPtr& job : roster_.all()) {
    if (job->is_here()) held.push_back({job, job->context, progress_now(*job), job->worked_s, job->suspect});
  }
  return held;
}

void JobTable::fail_in_memory(const Changing&, LiveJob& job) {
  const std::lock_guard lock(mutex_);
  job.state = store::JobState::kFailed;
  roster_.put(job, QueuePlace::kOut);
  tally_.ended(job.state);
}

/// REQUIRES mutex_.
JobProgress JobTable::progress_now(const LiveJob& job) const {
  JobProgress progress = job.progress;
  progress.state = job.state;
  if (progress.phase.empty()) progress.phase = "queued";
  return progress;
}

void JobTable::announce(const Changing&, const LiveJob& job) {
  const JobProgress now = progress(job);
  if (store::is_final(job.state) || !open_) {
    publisher_.ended(job.id, now);
  } else {
    publisher_.progress(job.id, now);
  }
}

void JobTable::count_answered(const Changing&) {
  const std::lock_guard lock(mutex_);
  tally_.answered();
}

LiveJobPtr JobTable::insert(const Changing&, const store::RequestContext& context, const store::JobRow& row) {
  auto job = std::make_shared<LiveJob>();
  job->id = row.id;
  job->context = context.for_job(row.id);
  job->context.given_up = job->interrupt;
  job->row = without_document(row);
  job->worked_s = static_cast<double>(row.worked_ms) / 1000;
  job->state = row.state;
  job->suspect = row.suspect;
  job->progress = progress_of_row(row);
  {
    const std::lock_guard lock(mutex_);
    job->waits_since = std::chrono::steady_clock::now();
    if (!open_ || !roster_.enter(job)) return nullptr;
  }
  bell_.notify_all();
  return job;
}

std::unique_ptr<JobRun> JobTable::remove(const Changing&, const LiveJobPtr& job) {
  const std::lock_guard lock(mutex_);
  roster_.leave(*job);
  return std::move(job->run);
}

bool JobTable::clear(const Changing&, LiveJob& job) {
  bool others = false;
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(job.suspect, false)) return false;
    others = roster_.first_suspect() != nullptr;
  }
  bell_.notify_all();
  return others;
}

MakeRoom JobTable::room_to_make(const LiveJob& job, int most) const {
  const std::lock_guard lock(mutex_);
  return open_ ? roster_.room_to_make(job, most) : MakeRoom::kNot;
}

LiveJobPtr JobTable::next_ready(const Changing&, WorkerKind kind, int most) const {
  const std::lock_guard lock(mutex_);
  return open_ ? roster_.next(kind, most) : nullptr;
}

void JobTable::make_wait(const Changing&, LiveJob& job) {
  {
    const std::lock_guard lock(mutex_);
    job.waits_since = std::chrono::steady_clock::now();
    roster_.put(job, QueuePlace::kFront);  // before its owner's others: what is begun is to end first
  }
  bell_.notify_all();
}

void JobTable::hand_out(const Changing&, LiveJob& job,
                        const std::function<std::unique_ptr<JobRun>(std::uint32_t epoch)>& make) {
  const std::lock_guard lock(mutex_);
  job.held = true;
  roster_.put(job, QueuePlace::kOut);  // one that had made room still stands there
  job.interrupt->store(false, std::memory_order_relaxed);
  job.aside = false;
  if (job.run) return;
  job.progress = {};
  job.run = make(static_cast<std::uint32_t>(job.context.lease));
}

void JobTable::take_back(const Changing&, LiveJob& job) {
  {
    const std::lock_guard lock(mutex_);
    job.held = false;
    job.aside = job.run && job.run->is_aside();
    if (job.run) job.loads_in_s = job.run->loads_in_s();
  }
  bell_.notify_all();  // it may have been resumed meanwhile
}

std::vector<LiveJobPtr> JobTable::all(const Changing&) const {
  const std::lock_guard lock(mutex_);
  return roster_.all();
}

int JobTable::parked(const Changing&) const {
  const std::lock_guard lock(mutex_);
  return roster_.parked();
}

void JobTable::open(const Changing&) {
  const std::lock_guard lock(mutex_);
  open_ = true;
}

void JobTable::close(const Changing&) {
  {
    const std::lock_guard lock(mutex_);
    open_ = false;
    closed_ = std::chrono::steady_clock::now();
    for (const LiveJobPtr& job : roster_.all()) {
      if (job->held) job->interrupt->store(true, std::memory_order_relaxed);
    }
  }
  bell_.notify_all();
}

LiveJobPtr JobTable::find(const store::RequestContext& context, const std::string& id) const {
  const std::lock_guard lock(mutex_);
  LiveJobPtr job = roster_.find(id);
  return job && job->context.owner == context.owner ? job : nullptr;
}

JobProgress JobTable::progress(const LiveJob& job) const {
  const std::lock_guard lock(mutex_);
  return progress_now(job);
}

void JobTable::set_stepping(const Changing&, LiveJob& job, bool stepping) {
  const std::lock_guard lock(mutex_);
  job.stepping = stepping;
}

bool JobTable::is_here(const LiveJob& job) const {
  const std::lock_guard lock(mutex_);
  return job.is_here();
}

bool JobTable::is_stepping(const LiveJob& job) const {
  const std::lock_guard lock(mutex_);
  return job.stepping;
}

store::JobState JobTable::state(const LiveJob& job) const {
  const std::lock_guard lock(mutex_);
  return job.state;
}

JobService::Counts JobTable::counts() const {
  const std::lock_guard lock(mutex_);
  JobService::Counts counts = tally_.so_far();
  roster_.count(unix_ms(), counts);
  return counts;
}

double JobTable::worked(const LiveJob& job) const {
  const std::lock_guard lock(mutex_);
  return job.worked_s;
}

bool JobTable::is_out_of_patience() const {
  constexpr auto kPatience = std::chrono::seconds(8);
  const std::lock_guard lock(mutex_);
  return !open_ && std::chrono::steady_clock::now() - closed_ > kPatience;
}

bool JobTable::wait_for_work(WorkerKind kind) {
  std::unique_lock lock(mutex_);
  while (open_ && roster_.next(kind) == nullptr) {
    // No bell tells when a drape has waited long enough.
    if (kind == WorkerKind::kExpress && roster_.anybody_waits()) {
      bell_.wait_for(lock, kExpressAfter / 3);
    } else {
      bell_.wait(lock);
    }
  }
  return open_;
}

void JobTable::pause(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  bell_.wait_for(lock, time, [this] { return !open_; });
}

void JobTable::hear(LiveJob& job, const JobProgress& progress) {
  {
    const std::lock_guard lock(mutex_);
    tally_.progressed(job.progress, progress);
    job.progress = progress;
    if (!next_state(job.state, JobEvent::kProgress)) return;
  }
  publisher_.progress(job.id, progress);
}

void JobTable::charge(LiveJob& job, std::string_view phase, double seconds) {
  const std::lock_guard lock(mutex_);
  tally_.worked(phase, seconds);
  roster_.charge(job, seconds);
  if (phase != kStillsPhase) job.worked_s += seconds;
}

}  // namespace toile::jobs
