#include "server/jobs/service.h"

#include <utility>

#include "server/jobs/input.h"
#include "server/jobs/queueing_service.h"
#include "server/jobs/row_progress.h"
#include "server/store/job_search.h"

namespace toile::jobs {

/// Why a job that is not in the table, or in a closed one, cannot change.
Error QueueingJobService::refusal(const store::RequestContext& context, const std::string& id,
                                  JobEvent event) {
  const store::JobRow row = TRY(store_.job(context, id));
  TRY(next_state(row.state, event));
  return {"jobs.stopped", "the server takes no jobs up just now; try again when it has started", "",
          ErrorKind::kUnavailable};
}

Status QueueingJobService::check_parking(const Changing& changing, const LiveJob& job) const {
  const bool takes_memory = job.state == store::JobState::kRunning && job.is_here() && !job.aside;
  if (!takes_memory || table_.parked(changing) < settings_.max_parked) return {};
  return Error{"jobs.too_many_paused",
               "as many drapes lie paused in memory as there is room for; resume or cancel one first", "",
               ErrorKind::kTooMany};
}

Result<store::JobRow> QueueingJobService::on_request(const store::RequestContext& context,
                                                     const std::string& id, JobEvent event,
                                                     const RowEdit& edit, bool one_frame) {
  std::unique_ptr<JobRun> run;  // freed after the lock
  const Changing changing = table_.changing();
  const LiveJobPtr job = table_.find(context, id);
  if (!job || !table_.is_open(changing)) return refusal(context, id, event);
  if (event == JobEvent::kPause) {
    TRY(check_parking(changing, *job));
  }
  const bool interrupted = event == JobEvent::kPause && job->state == store::JobState::kRunning;
  TRY(table_.change(changing, *job, event, interrupted ? RowEdit(uncount) : edit, By::kRequest));
  table_.set_stepping(changing, *job, one_frame);
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

Result<store::Made<store::JobRow>> QueueingJobService::submit(const store::RequestContext& context,
                                                              const std::string& project_id,
                                                              const std::string& idempotency_key,
                                                              const JobWish& wish) {
  std::optional<store::JobRow> before = TRY(store_.job_of_key(context, idempotency_key));
  if (before && before->project_id == project_id) {
    return store::Made<store::JobRow>{without_document(std::move(*before)), false};
  }
  TRY(places_.check(1));
  store::JobRow row = TRY(row_of_drape(documents_, context, project_id, settings_.limits, wish.from));
  row.priority = wish.priority;
  row.pictures = wish.pictures;
  row.tags = wish.tags;
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
  row.pictures = before.pictures;
  row.cell = before.cell;
  row.tags = TRY(store::tags_of_job(store_, context, id));
  return queue(context, std::move(row), idempotency_key, true);
}

/// `anew`: whatever equal ones there are. The store takes on many at once, so nothing is held meanwhile but a
/// place.
Result<store::Made<store::JobRow>> QueueingJobService::queue(const store::RequestContext& context,
                                                             store::JobRow row,
                                                             const std::string& idempotency_key, bool anew) {
  row.input = input_of(row, settings_.engine, settings_.still_width, settings_.still_height);
  const QueuePlaces::Held place = TRY(places_.take(1));  // others came while the document was read
  store::Made<store::JobRow> made = TRY(store_.create_job(context, std::move(row), idempotency_key));
  if (!made.anew) return store::Made<store::JobRow>{without_document(std::move(made)), false};
  return store::Made<store::JobRow>{take_in(context, std::move(made), anew), true};
}

/// What the store has just taken on, unless look_round() has met it since.
store::JobRow QueueingJobService::take_in(const store::RequestContext& context, store::JobRow made,
                                          bool anew) {
  const Changing changing = table_.changing();
  if (table_.find(context, made.id)) return without_document(std::move(made));
  return begin(changing, context, made, anew);
}

/// As it stands then: it may have ended already.
store::JobRow QueueingJobService::begin(const Changing& changing, const store::RequestContext& context,
                                        const store::JobRow& made, bool anew) {
  std::optional<store::JobRow> ended = anew ? std::nullopt : answered(changing, context, made);
  if (ended) return std::move(*ended);
  const LiveJobPtr job = table_.insert(changing, context, made);
  if (job) table_.announce(changing, *job);
  context.log.info("job queued", {{"job", made.id}, {"project", made.project_id}});
  return without_document(made);
}

/// Each cell is taken up by itself, so that others get in between: an answer reads all results of a drape.
Result<store::Made<store::SweptJobs>> QueueingJobService::submit_sweep(const store::RequestContext& context,
                                                                       const SweepWish& wish,
                                                                       const std::string& idempotency_key) {
  store::Sweeps* const sweeps = store::sweeps_of(store_);
  if (!sweeps)
    return Error{"jobs.no_sweeps", "this server's store keeps no sweeps", "", ErrorKind::kUnavailable};
  store::SweptJobs before = TRY(sweeps->sweep_of_key(context, idempotency_key));
  if (!before.sweep.id.empty() && before.sweep.project_id == wish.project_id)
    return store::Made<store::SweptJobs>{std::move(before), false};
  TRY(places_.check(1));
  store::SweptJobs wanted = TRY(swept_jobs(documents_, context, wish, settings_.limits));
  for (store::JobRow& job : wanted.jobs)
    job.input = input_of(job, settings_.engine, settings_.still_width, settings_.still_height);
  const QueuePlaces::Held places = TRY(places_.take(static_cast<int>(wanted.jobs.size())));
  store::Made<store::SweptJobs> made = TRY(sweeps->create_sweep(context, std::move(wanted), idempotency_key));
  if (!made.anew) return made;
  context.log.info("sweep queued", {{"sweep", made.sweep.id}, {"jobs", std::to_string(made.jobs.size())}});
  for (store::JobRow& job : made.jobs) job = take_in(context, std::move(job), wish.manner.anew);
  return made;
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

std::unique_ptr<JobService> make_job_service(documents::Documents& documents, Publisher& publisher,
                                             const JobServiceSettings& settings, const Log& log) {
  return std::make_unique<QueueingJobService>(documents, publisher, settings, log);
}

}  // namespace toile::jobs
