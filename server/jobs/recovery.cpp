#include "server/jobs/recovery.h"

#include <algorithm>

namespace toile::jobs {

Recovery recover(const store::JobRow& job, bool further, int running) {
  if (job.state != store::JobState::kRunning) return {Fate::kStays, job.attempt};
  if (further) return {Fate::kGoesOn, 0};
  if (running > 1) return {Fate::kGoesAlone, std::max(0, job.attempt - 1)};
  if (job.attempt < kMostAttempts) return {Fate::kGoesAlone, job.attempt};
  return {job.verdict ? Fate::kWithoutPictures : Fate::kFails, job.attempt};
}

}  // namespace toile::jobs
