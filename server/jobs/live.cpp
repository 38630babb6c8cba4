// What viewers do to a drape under way: hands on its cloth, and one step at a time.

#include <utility>

#include "server/jobs/queueing_service.h"

namespace toile::jobs {

Status QueueingJobService::touch(const store::RequestContext& context, const std::string& id,
                                 LiveTouch touch) {
  const LiveJobPtr job = table_.find(context, id);
  const store::JobState state = job ? table_.state(*job) : TRY(store_.job(context, id)).state;
  if (state != store::JobState::kRunning && state != store::JobState::kPaused)
    return Error{"jobs.state",
                 "the cloth of a job that is " + std::string(store::name_of(state)) +
                     " cannot be touched; it must run or be paused",
                 "", ErrorKind::kConflict};
  if (!table_.is_here(*job))
    return Error{"live.elsewhere", "another process works on this drape, and hands do not reach there", "",
                 ErrorKind::kConflict};
  TRY(job->hands->put(std::move(touch)));
  if (state != store::JobState::kPaused) return {};
  const Changing changing = table_.changing();  // nobody takes it up meanwhile
  if (job->held || !job->run || job->state != store::JobState::kPaused) return {};
  table_.hear(*job, job->run->touch_where_it_stands(*job->hands));
  table_.announce(changing, *job);
  return {};
}

Result<store::JobRow> QueueingJobService::step(const store::RequestContext& context, const std::string& id) {
  return on_request(context, id, JobEvent::kResume, {}, true);
}

}  // namespace toile::jobs
