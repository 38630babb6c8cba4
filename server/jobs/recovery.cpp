#include "server/jobs/recovery.h"

#include <algorithm>
#include <string>

#include "server/jobs/row_edits.h"

namespace toile::jobs {

Recovery recover(const store::JobRow& job, bool further, int running) {
  if (job.state != store::JobState::kRunning) return {Fate::kStays, job.attempt};
  if (further) return {Fate::kGoesOn, 0};
  if (running > 1) return {Fate::kGoesAlone, std::max(0, job.attempt - 1)};
  if (job.attempt < kMostAttempts) return {Fate::kGoesAlone, job.attempt};
  return {job.verdict ? Fate::kWithoutPictures : Fate::kFails, job.attempt};
}

namespace {

/// The end of a job that has taken its holder down too often.
RunEnd last_of(const store::JobRow& row, const Recovery& recovery) {
  if (recovery.fate == Fate::kWithoutPictures) return without_pictures(row);
  RunEnd last;
  last.code = "jobs.attempts";
  last.reason = "the server broke down " + std::to_string(recovery.attempt) + " times while this was draped";
  return last;
}

}  // namespace

void judge(store::Store::LeftJob& left) {
  store::JobRow& row = left.owned.job;
  const bool further = left.kept_ms > 0 && left.kept_ms >= row.started_ms;
  const Recovery recovery = recover(row, further, left.running);
  if (recovery.fate == Fate::kStays) return;
  if (recovery.fate == Fate::kFails || recovery.fate == Fate::kWithoutPictures) {
    const RunEnd last = last_of(row, recovery);
    ended(last)(row);
    row.state = last.succeeded ? store::JobState::kSucceeded : store::JobState::kFailed;
    row.ended_ms = unix_ms();
    row.suspect = false;
    return;
  }
  requeued()(row);
  row.state = store::JobState::kQueued;
  row.attempt = recovery.attempt;
  row.suspect = recovery.fate == Fate::kGoesAlone;
}

}  // namespace toile::jobs
