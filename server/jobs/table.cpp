#include "server/jobs/table.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "server/jobs/row_progress.h"

namespace toile::jobs {

std::int64_t unix_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

store::JobRow without_document(store::JobRow row) {
  row.document.clear();
  row.files.clear();
  return row;
}

RowEdit with_reason(std::string code, std::string reason, std::string where) {
  return [code = std::move(code), reason = std::move(reason), where = std::move(where)](store::JobRow& row) {
    row.reason_code = code;
    row.reason = reason;
    row.reason_where = where;
  };
}

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
    count_times(event, before, row);
    job.row = without_document(std::move(row));
    job.state = next.state;
    queue_.put(job.id, next.effects.queue);
    job.waits_since = std::chrono::steady_clock::now();
    if (next.effects.interrupt) job.interrupt->store(true, std::memory_order_relaxed);
    if (next.effects.ends) count_end(job.state);
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

Status JobTable::release(const Changing&, LiveJob& job, std::unique_ptr<JobRun>& run) {
  store::JobRow row = TRY(store_.change_job(job.context, job.id, [](store::JobRow& now) -> Status {
    now.lease.holder.clear();
    return {};
  }));
  {
    const std::lock_guard lock(mutex_);
    run = std::move(job.run);
    job.context.lease = 0;
    job.wanted_away = false;
    job.row = without_document(std::move(row));
    place(job, false);
  }
  bell_.notify_all();
  return {};
}

/// Where in the queue a job stands by its row. What has made room waits there as running. REQUIRES mutex_.
void JobTable::place(LiveJob& job, bool changed) {
  const bool free = job.row.lease.holder.empty() || job.is_here();
  if (job.state == store::JobState::kQueued && free) {
    if (changed || !queue_.contains(job.id)) queue_.put(job.id, QueuePlace::kBack);
  } else if (job.state != store::JobState::kRunning || !job.is_here()) {
    queue_.put(job.id, QueuePlace::kOut);
  }
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
    if (changed && final) count_end(row.state);
    if (changed && job.held) job.interrupt->store(true, std::memory_order_relaxed);
    if (changed && job.is_here()) job.wanted_away = row.state == store::JobState::kPaused;
    job.state = row.state;
    job.row = without_document(row);
    if (!job.is_here()) {
      job.suspect = row.suspect;
      job.worked_s = static_cast<double>(row.worked_ms) / 1000;
      job.progress = progress_of_row(row);
    }
    place(job, changed);
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
  for (const auto& [id, job] : jobs_) {
    if (job->is_here()) held.push_back({job, job->context, progress_now(*job), job->worked_s, job->suspect});
  }
  return held;
}

void JobTable::fail_in_memory(const Changing&, LiveJob& job) {
  const std::lock_guard lock(mutex_);
  job.state = store::JobState::kFailed;
  queue_.put(job.id, QueuePlace::kOut);
  count_end(job.state);
}

/// REQUIRES mutex_.
void JobTable::count_end(store::JobState state) {
  if (state == store::JobState::kSucceeded) ++totals_.succeeded;
  if (state == store::JobState::kFailed) ++totals_.failed;
  if (state == store::JobState::kCancelled) ++totals_.cancelled;
}

/// REQUIRES mutex_.
void JobTable::count_times(JobEvent event, const store::JobRow& before, const store::JobRow& after) {
  const auto seconds = [](std::int64_t from, std::int64_t to) {
    return static_cast<double>(std::max<std::int64_t>(0, to - from)) / 1000;
  };
  if (event == JobEvent::kClaim && before.started_ms == 0)
    totals_.wait.add(seconds(after.created_ms, after.started_ms));
  if (store::is_final(after.state) && after.started_ms > 0)
    totals_.run.add(seconds(after.started_ms, after.ended_ms));
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
  ++totals_.succeeded;
  ++totals_.answered;
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
    if (!open_ || !jobs_.emplace(job->id, job).second) return nullptr;
    shares_.enter(job->context.owner);
    job->waits_since = std::chrono::steady_clock::now();
    place(*job, true);
  }
  bell_.notify_all();
  return job;
}

std::unique_ptr<JobRun> JobTable::remove(const Changing&, const LiveJobPtr& job) {
  const std::lock_guard lock(mutex_);
  queue_.put(job->id, QueuePlace::kOut);
  if (jobs_.erase(job->id) > 0) shares_.leave(job->context.owner);
  return std::move(job->run);
}

bool JobTable::clear(const Changing&, LiveJob& job) {
  bool others = false;
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(job.suspect, false)) return false;
    others = first_suspect() != nullptr;
  }
  bell_.notify_all();
  return others;
}

/// REQUIRES mutex_.
LiveJobPtr JobTable::first_suspect() const {
  const std::optional<std::string> id = queue_.first([&](const std::string& waiting) {
    const LiveJob& job = *jobs_.at(waiting);
    return !job.held && job.suspect;
  });
  return id ? jobs_.at(*id) : nullptr;
}

/// REQUIRES mutex_.
Claim JobTable::claim_of(const LiveJob& job) const {
  return {shares_.had(job.context.owner), job.row.priority};
}

/// REQUIRES mutex_.
bool JobTable::is_for(WorkerKind kind, const LiveJob& job) const {
  if (job.held) return false;
  if (kind == WorkerKind::kAny) return true;
  return job.row.priority == store::JobPriority::kInteractive && job.run == nullptr &&
         std::chrono::steady_clock::now() - job.waits_since > kExpressAfter;
}

/// REQUIRES mutex_.
LiveJobPtr JobTable::next_in_turn(WorkerKind kind) const {
  std::vector<LiveJobPtr> waiting;
  std::vector<Claim> claims;
  for (const std::string& id : queue_.ids()) {
    const LiveJobPtr& job = jobs_.at(id);
    if (!is_for(kind, *job)) continue;
    waiting.push_back(job);
    claims.push_back(claim_of(*job));
  }
  const std::optional<std::size_t> turn = next_turn(claims);
  return turn ? waiting[*turn] : nullptr;
}

/// REQUIRES mutex_.
LiveJobPtr JobTable::ready(WorkerKind kind) const {
  bool anybody_runs = false, suspect_runs = false;
  for (const auto& [id, job] : jobs_) {
    anybody_runs = anybody_runs || job->held;
    suspect_runs = suspect_runs || (job->held && job->suspect);
  }
  if (suspect_runs) return nullptr;
  if (LiveJobPtr suspect = first_suspect()) return anybody_runs ? nullptr : suspect;
  return next_in_turn(kind);
}

bool JobTable::is_to_make_room(const LiveJob& job, int most) const {
  const std::lock_guard lock(mutex_);
  if (!open_ || job.suspect || first_suspect() || begun_now() >= most) return false;
  const LiveJobPtr next = next_in_turn(WorkerKind::kAny);
  return next && makes_room(claim_of(job), claim_of(*next));
}

LiveJobPtr JobTable::next_ready(const Changing&, WorkerKind kind) const {
  const std::lock_guard lock(mutex_);
  return open_ ? ready(kind) : nullptr;
}

void JobTable::make_wait(const Changing&, LiveJob& job) {
  {
    const std::lock_guard lock(mutex_);
    job.waits_since = std::chrono::steady_clock::now();
    queue_.put(job.id, QueuePlace::kFront);  // before its owner's others: what is begun is to end first
  }
  bell_.notify_all();
}

void JobTable::hand_out(const Changing&, LiveJob& job,
                        const std::function<std::unique_ptr<JobRun>(std::uint32_t epoch)>& make) {
  const std::lock_guard lock(mutex_);
  job.held = true;
  queue_.put(job.id, QueuePlace::kOut);  // one that had made room still stands there
  job.interrupt->store(false, std::memory_order_relaxed);
  if (job.run) return;
  job.progress = {};
  job.run = make(static_cast<std::uint32_t>(job.context.lease));
}

void JobTable::take_back(const Changing&, LiveJob& job) {
  {
    const std::lock_guard lock(mutex_);
    job.held = false;
  }
  bell_.notify_all();  // it may have been resumed meanwhile
}

std::vector<LiveJobPtr> JobTable::all(const Changing&) const {
  const std::lock_guard lock(mutex_);
  std::vector<LiveJobPtr> jobs;
  for (const auto& [id, job] : jobs_) jobs.push_back(job);
  return jobs;
}

int JobTable::begun(const Changing&) const {
  const std::lock_guard lock(mutex_);
  return begun_now();
}

/// REQUIRES mutex_.
int JobTable::begun_now() const {
  return static_cast<int>(std::count_if(jobs_.begin(), jobs_.end(),
                                        [](const auto& entry) { return entry.second->run != nullptr; }));
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
    for (const auto& [id, job] : jobs_) {
      if (job->held) job->interrupt->store(true, std::memory_order_relaxed);
    }
  }
  bell_.notify_all();
}

LiveJobPtr JobTable::find(const store::RequestContext& context, const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(id);
  return found != jobs_.end() && found->second->context.owner == context.owner ? found->second : nullptr;
}

JobProgress JobTable::progress(const LiveJob& job) const {
  const std::lock_guard lock(mutex_);
  return progress_now(job);
}

store::JobState JobTable::state(const LiveJob& job) const {
  const std::lock_guard lock(mutex_);
  return job.state;
}

JobService::Counts JobTable::counts() const {
  const std::lock_guard lock(mutex_);
  JobService::Counts counts = totals_;
  const std::int64_t now_ms = unix_ms();
  std::int64_t oldest_ms = now_ms;
  for (const auto& [id, job] : jobs_) {
    counts.queued += job->state == store::JobState::kQueued;
    counts.running += job->state == store::JobState::kRunning;
    counts.paused += job->state == store::JobState::kPaused;
    if (job->state == store::JobState::kQueued) oldest_ms = std::min(oldest_ms, job->row.created_ms);
  }
  counts.oldest_queued_s = static_cast<double>(now_ms - oldest_ms) / 1000;
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
  while (open_ && ready(kind) == nullptr) {
    // No bell tells when a drape has waited long enough.
    if (kind == WorkerKind::kExpress && !queue_.ids().empty()) {
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
    totals_.steps += std::max(0, progress.step - std::max(job.progress.step, progress.first_step));
    job.progress = progress;
    if (!next_state(job.state, JobEvent::kProgress)) return;
  }
  publisher_.progress(job.id, progress);
}

void JobTable::charge(LiveJob& job, std::string_view phase, double seconds) {
  const std::lock_guard lock(mutex_);
  totals_.work_s[std::string(phase)] += seconds;
  shares_.charge(job.context.owner, seconds);
  if (phase != kStillsPhase) job.worked_s += seconds;
}

}  // namespace toile::jobs
