#include "server/jobs/tally.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace toile::jobs {

void JobTally::changed(JobEvent event, const store::JobRow& before, const store::JobRow& after) {
  const auto seconds = [](std::int64_t from, std::int64_t to) {
    return static_cast<double>(std::max<std::int64_t>(0, to - from)) / 1000;
  };
  if (event == JobEvent::kClaim && before.started_ms == 0)
    counts_.wait.add(seconds(after.created_ms, after.started_ms));
  if (store::is_final(after.state) && after.started_ms > 0)
    counts_.run.add(seconds(after.started_ms, after.ended_ms));
}

void JobTally::ended(store::JobState state) {
  if (state == store::JobState::kSucceeded) ++counts_.succeeded;
  if (state == store::JobState::kFailed) ++counts_.failed;
  if (state == store::JobState::kCancelled) ++counts_.cancelled;
}

void JobTally::answered() {
  ++counts_.succeeded;
  ++counts_.answered;
}

void JobTally::progressed(const JobProgress& before, const JobProgress& now) {
  counts_.steps += std::max(0, now.step - std::max(before.step, now.first_step));
}

void JobTally::worked(std::string_view phase, double seconds) {
  counts_.work_s[std::string(phase)] += seconds;
}

}  // namespace toile::jobs
