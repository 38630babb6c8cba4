#include "server/jobs/roster.h"

#include <algorithm>
#include <optional>

namespace toile::jobs {
namespace {

bool is_for(WorkerKind kind, const LiveJob& job) {
  if (job.held) return false;
  if (kind == WorkerKind::kAny) return true;
  return job.row.priority == store::JobPriority::kInteractive && job.run == nullptr &&
         std::chrono::steady_clock::now() - job.waits_since > kExpressAfter;
}

}  // namespace

bool JobRoster::enter(const LiveJobPtr& job) {
  if (!jobs_.emplace(job->id, job).second) return false;
  shares_.enter(job->context.owner);
  place(*job, true);
  return true;
}

void JobRoster::leave(const LiveJob& job) {
  queue_.put(job.id, QueuePlace::kOut);
  if (jobs_.erase(job.id) > 0) shares_.leave(job.context.owner);
}

LiveJobPtr JobRoster::find(const std::string& id) const {
  const auto found = jobs_.find(id);
  return found == jobs_.end() ? nullptr : found->second;
}

std::vector<LiveJobPtr> JobRoster::all() const {
  std::vector<LiveJobPtr> jobs;
  for (const auto& [id, job] : jobs_) jobs.push_back(job);
  return jobs;
}

void JobRoster::place(const LiveJob& job, bool changed) {
  const bool free = job.row.lease.holder.empty() || job.is_here();
  if (job.state == store::JobState::kQueued && free) {
    if (changed || !queue_.contains(job.id)) queue_.put(job.id, QueuePlace::kBack);
  } else if (job.state != store::JobState::kRunning || !job.is_here()) {
    queue_.put(job.id, QueuePlace::kOut);
  }
}

LiveJobPtr JobRoster::first_suspect() const {
  const std::optional<std::string> id = queue_.first([&](const std::string& waiting) {
    const LiveJob& job = *jobs_.at(waiting);
    return !job.held && job.suspect;
  });
  return id ? jobs_.at(*id) : nullptr;
}

Claim JobRoster::claim_of(const LiveJob& job) const {
  return {shares_.had(job.context.owner), job.row.priority};
}

LiveJobPtr JobRoster::next_in_turn(WorkerKind kind, bool begun_only) const {
  std::vector<LiveJobPtr> waiting;
  std::vector<Claim> claims;
  for (const std::string& id : queue_.ids()) {
    const LiveJobPtr& job = jobs_.at(id);
    if (!is_for(kind, *job) || (begun_only && !job->is_in_memory())) continue;
    waiting.push_back(job);
    claims.push_back(claim_of(*job));
  }
  const std::optional<std::size_t> turn = next_turn(claims);
  return turn ? waiting[*turn] : nullptr;
}

LiveJobPtr JobRoster::next(WorkerKind kind, int most) const {
  bool anybody_runs = false, suspect_runs = false;
  for (const auto& [id, job] : jobs_) {
    anybody_runs = anybody_runs || job->held;
    suspect_runs = suspect_runs || (job->held && job->suspect);
  }
  if (suspect_runs) return nullptr;
  if (LiveJobPtr suspect = first_suspect()) return anybody_runs ? nullptr : suspect;
  if (begun() >= most) {
    if (LiveJobPtr begun = next_in_turn(kind, true)) return begun;
  }
  return next_in_turn(kind);
}

MakeRoom JobRoster::room_to_make(const LiveJob& job, int most) const {
  if (job.suspect || first_suspect()) return MakeRoom::kNot;
  const LiveJobPtr next = next_in_turn(WorkerKind::kAny);
  if (!next) return MakeRoom::kNot;
  if (next->is_in_memory() || begun() < most)
    return makes_room(claim_of(job), claim_of(*next), next->load_s()) ? MakeRoom::kInMemory : MakeRoom::kNot;
  if (makes_room(claim_of(job), claim_of(*next), job.loads_in_s + next->load_s())) return MakeRoom::kAside;
  const LiveJobPtr begun = next_in_turn(WorkerKind::kAny, true);
  return begun && makes_room(claim_of(job), claim_of(*begun)) ? MakeRoom::kInMemory : MakeRoom::kNot;
}

int JobRoster::begun() const {
  return static_cast<int>(std::count_if(jobs_.begin(), jobs_.end(),
                                        [](const auto& entry) { return entry.second->is_in_memory(); }));
}

int JobRoster::parked() const {
  return static_cast<int>(std::count_if(jobs_.begin(), jobs_.end(), [](const auto& entry) {
    return entry.second->is_in_memory() && entry.second->state == store::JobState::kPaused;
  }));
}

void JobRoster::count(std::int64_t now_ms, JobService::Counts& counts) const {
  std::int64_t oldest_ms = now_ms;
  counts.in_memory = begun();
  for (const auto& [id, job] : jobs_) {
    counts.queued += job->state == store::JobState::kQueued;
    counts.running += job->state == store::JobState::kRunning;
    counts.paused += job->state == store::JobState::kPaused;
    if (job->state == store::JobState::kQueued) oldest_ms = std::min(oldest_ms, job->row.created_ms);
  }
  counts.oldest_queued_s = static_cast<double>(now_ms - oldest_ms) / 1000;
}

}  // namespace toile::jobs
