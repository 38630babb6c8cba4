#pragma once
// The jobs that this process knows, the order in which they wait, and whose turn it is.

#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "server/jobs/live_job.h"
#include "server/jobs/queue.h"
#include "server/jobs/service.h"
#include "server/jobs/turn.h"
#include "server/shares/owner_shares.h"

namespace toile::jobs {

/// What a worker takes.
enum class WorkerKind {
  kAny,      ///< whatever is next
  kExpress,  ///< interactive drapes that have waited in vain for another, to begin them
};
/// How long that is: workers look up between slices, but not while they mesh, dress, or wait for pictures.
inline constexpr auto kExpressAfter = std::chrono::milliseconds(300);

/// Not thread-safe: the table of jobs locks, and alone changes jobs.
class JobRoster {
 public:
  /// Takes a job in, at the end of the queue unless it is paused or another process has it. False when it is
  /// there already.
  bool enter(const LiveJobPtr& job);
  /// Twice is safe.
  void leave(const LiveJob& job);
  /// Nothing where there is none of that id.
  LiveJobPtr find(const std::string& id) const;
  std::vector<LiveJobPtr> all() const;

  void put(const LiveJob& job, QueuePlace place) { queue_.put(job.id, place); }
  /// Where in the queue it stands by its row; at the end where `changed` says that its state has. What has
  /// made room waits there as running.
  void place(const LiveJob& job, bool changed);
  bool anybody_waits() const { return !queue_.ids().empty(); }

  /// Of those that no worker holds, whose turn it is (turn.h); a suspect before all others, and once nothing
  /// else runs. Nothing while a suspect runs. Where no more than `most` drapes may lie in memory and that
  /// many do, one of them, if any of them waits.
  LiveJobPtr next(WorkerKind kind, int most = std::numeric_limits<int>::max()) const;
  /// The first of those that wait and may have crashed their holder.
  LiveJobPtr first_suspect() const;
  /// Whether the holder of the job is to make room for one whose turn it is rather, and how: where no more
  /// than `most` drapes may lie in memory and that many do, it leaves memory for one that does not lie there.
  MakeRoom room_to_make(const LiveJob& job, int most) const;
  /// Jobs whose drape lies in memory.
  int begun() const;
  /// Those of them that are paused.
  int parked() const;

  /// Takes down what the job's owner has had of the workers.
  void charge(const LiveJob& job, double seconds) { shares_.charge(job.context.owner, seconds); }
  /// Adds those that wait, run and are paused. `now_ms`: of the clock that rows go by.
  void count(std::int64_t now_ms, JobService::Counts& counts) const;

 private:
  LiveJobPtr next_in_turn(WorkerKind kind, bool begun_only = false) const;
  Claim claim_of(const LiveJob& job) const;

  std::map<std::string, LiveJobPtr> jobs_;  ///< by id
  JobQueue queue_;
  shares::OwnerShares shares_;  ///< of the workers' time
};

}  // namespace toile::jobs
