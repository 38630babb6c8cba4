#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include "core/base/text.h"
#include "server/jobs/input.h"
#include "server/jobs/queueing_service.h"
#include "server/jobs/row_progress.h"

namespace toile::jobs {

namespace {

/// How often an end is offered to a store that is busy, which waits for some seconds each time.
constexpr int kMostTries = 3;
/// After the store has refused a claim a worker waits: a full disk is not emptied in a millisecond.
constexpr auto kStorePause = std::chrono::seconds(1);

/// Counts who has a drape in hand.
class AtWork {
 public:
  explicit AtWork(std::atomic<int>& count) : count_(count) { ++count_; }
  ~AtWork() { --count_; }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  std::atomic<int>& count_;
};

}  // namespace

/// Waits for a job; nothing once the service stops.
LiveJobPtr QueueingJobService::claim(WorkerKind kind) {
  while (table_.wait_for_work(kind)) {
    {
      const Changing changing = table_.changing();
      LiveJobPtr job = table_.next_ready(changing, kind, settings_.workers + settings_.max_parked);
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
                         settings_.limits,
                         settings_.engine};
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
  const AtWork at_work(working_);
  control.threads = [this] { return std::max(1, settings_.workers / std::max(1, working_.load())); };
  control.interrupt = job->interrupt.get();
  // A stop waits a while for pictures of a finished drape; a person who paused or cancelled does not.
  control.abandon = [&] {
    return table_.state(*job) != store::JobState::kRunning || table_.is_out_of_patience();
  };
  control.worth_keeping = [&] { return !store::is_final(table_.state(*job)); };
  control.hands = job->hands.get();
  control.shape = job->shape.get();
  control.one_frame = table_.is_stepping(*job);
  control.make_room = [&] { return table_.room_to_make(*job, settings_.workers + settings_.max_parked); };
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
    } else if (table_.is_open(changing)) {           // else it is told when it has been given back
      if (job->state == store::JobState::kPaused) {  // its last slice came after the pause was written
        const Status told = table_.tell_work(changing, *job);
        if (!told) job->context.log.warn("work on a paused job not kept", told.error());
      }
      if (job->stepping && job->state == store::JobState::kRunning) end_step(changing, *job);
      table_.announce(changing, *job);
      if (job->state == store::JobState::kRunning) table_.make_wait(changing, *job);
    }
  }
  if (unnamed_results) forget_results(*job);
}

/// A step is over: it is paused as before.
void QueueingJobService::end_step(const Changing& changing, LiveJob& job) {
  table_.set_stepping(changing, job, false);
  const Status paused = table_.change(changing, job, JobEvent::kPause, uncount);
  if (!paused) return job.context.log.warn("not paused after its step", paused.error());
  if (job.run) job.run->keep_where_it_stands();
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

}  // namespace toile::jobs
