#pragma once
// What has come of jobs since the service was made.

#include <string_view>

#include "server/jobs/publisher.h"
#include "server/jobs/service.h"
#include "server/jobs/transition.h"
#include "server/store/store.h"

namespace toile::jobs {

/// Not thread-safe: the table of jobs locks.
class JobTally {
 public:
  /// Times of a job whose row has changed, as far as it was claimed for the first time or has ended.
  void changed(JobEvent event, const store::JobRow& before, const store::JobRow& after);
  /// A job has come to this state, which is final; nothing for any other.
  void ended(store::JobState state);
  /// A job that has ended before it was taken in.
  void answered();
  /// What a holder tells after `before`.
  void progressed(const JobProgress& before, const JobProgress& now);
  void worked(std::string_view phase, double seconds);

  /// Nothing of what waits or runs now.
  const JobService::Counts& so_far() const { return counts_; }

 private:
  JobService::Counts counts_;
};

}  // namespace toile::jobs
