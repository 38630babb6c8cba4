// What viewers do to a drape under way: hands on its cloth, and one step at a time.

#include <chrono>
#include <optional>
#include <utility>

#include "server/jobs/input.h"
#include "server/jobs/queueing_service.h"
#include "server/store/job_search.h"

namespace toile::jobs {

namespace {

/// Workers look up every 50 ms; a machine with other work on it may be slow.
constexpr auto kAnswerWithin = std::chrono::seconds(5);
/// After so long it is looked whether a worker has the drape still: one that let go of it in between never
/// answers.
constexpr auto kAnswerSlice = std::chrono::milliseconds(200);

bool waits(store::JobState state) {
  return state == store::JobState::kPaused || state == store::JobState::kQueued;
}

}  // namespace

/// While it stands in the queue with a drape begun, hands are on it as when it is paused: between a pause and
/// its worker, or where it made room for others.
Status QueueingJobService::touch(const store::RequestContext& context, const std::string& id,
                                 LiveTouch touch) {
  using store::JobState;
  const LiveJobPtr job = table_.find(context, id);
  const JobState state = job ? table_.state(*job) : TRY(store_.job(context, id)).state;
  const bool begun = state == JobState::kQueued && job && table_.progress(*job).step > 0;
  if (state != JobState::kRunning && state != JobState::kPaused && !begun)
    return Error{"jobs.state",
                 "the cloth of a job that is " + std::string(store::name_of(state)) +
                     " cannot be touched; it must run or be paused",
                 "", ErrorKind::kConflict};
  if (!table_.is_here(*job))
    return Error{"live.elsewhere", "another process works on this drape, and hands do not reach there", "",
                 ErrorKind::kConflict};
  TRY(job->hands->put(std::move(touch)));
  if (state == JobState::kRunning) return {};
  const Changing changing = table_.changing();  // nobody takes it up meanwhile
  if (job->held || !job->run || !waits(job->state)) return {};
  table_.hear(*job, job->run->touch_where_it_stands(*job->hands));
  table_.announce(changing, *job);
  return {};
}

Result<store::JobRow> QueueingJobService::step(const store::RequestContext& context, const std::string& id) {
  return on_request(context, id, JobEvent::kResume, {}, true);
}

/// Asked of its worker; of a drape that lies in memory, looked at; of one that is being drawn, what it left.
Result<QueueingJobService::HangsNow> QueueingJobService::shape_now(const store::RequestContext& context,
                                                                   const LiveJobPtr& job) {
  const auto end = std::chrono::steady_clock::now() + kAnswerWithin;
  do {
    const std::string phase = table_.progress(*job).phase;
    if (phase == kStillsPhase) return HangsNow{TRY(store_.result_bytes(context, job->id, kShapeFile)), true};
    {
      const Changing changing = table_.changing();
      if (!job->held) return job->run ? HangsNow{TRY(job->run->shape())} : HangsNow{};
    }
    // Whoever meshes or dresses does not look up, and has nothing that hangs.
    if (phase != "drape") return HangsNow{};
    if (std::optional<std::string> shape = job->shape->ask(kAnswerSlice)) return HangsNow{std::move(*shape)};
  } while (std::chrono::steady_clock::now() < end);
  return Error{"jobs.no_shape", "the drape does not answer how its garment hangs; try again", "",
               ErrorKind::kUnavailable};
}

Result<store::Made<store::JobRow>> QueueingJobService::go_on(const store::RequestContext& context,
                                                             const std::string& id,
                                                             const std::string& idempotency_key) {
  const std::optional<store::JobRow> before = TRY(store_.job_of_key(context, idempotency_key));
  const store::JobRow old = TRY(store_.job(context, id));
  if (before && before->project_id == old.project_id)
    return store::Made<store::JobRow>{without_document(*before), false};
  const LiveJobPtr job = table_.find(context, id);
  if (!job || store::is_final(table_.state(*job)))
    return Error{"jobs.state",
                 "a job that is " + std::string(store::name_of(old.state)) +
                     " does not go on; start a drape from its end instead",
                 "", ErrorKind::kConflict};
  if (!table_.is_here(*job) && !old.lease.holder.empty())
    return Error{"live.elsewhere", "another process works on this drape, and nothing reaches it there", "",
                 ErrorKind::kConflict};
  const HangsNow hangs = TRY(shape_now(context, job));
  store::JobRow row =
      TRY(row_of_drape_on(documents_, context, old.project_id, settings_.limits, hangs.shape));
  row.priority = old.priority;
  row.pictures = old.pictures;
  row.tags = TRY(store::tags_of_job(store_, context, id));
  const store::Made<store::JobRow> made = TRY(queue(context, std::move(row), idempotency_key, true));
  if (hangs.for_good) {
    if (table_.state(*job) != store::JobState::kPaused) return made;
    const Result<store::JobRow> resumed = on_request(context, id, JobEvent::kResume, {});
    if (!resumed) context.log.info("it waits for its pictures still", {{"job", id}});
    return made;
  }
  const Result<store::JobRow> ended = on_request(context, id, JobEvent::kCancel, superseded(made.id));
  if (!ended) context.log.info("it ended before it was superseded", {{"job", id}});
  return made;
}

}  // namespace toile::jobs
