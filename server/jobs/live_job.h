#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "server/jobs/publisher.h"
#include "server/jobs/runner.h"
#include "server/jobs/shape_wish.h"
#include "server/jobs/touch_inbox.h"
#include "server/store/store.h"

namespace toile::jobs {

/// A job that has not ended, or whose worker has not yet let go. Members are written under both locks of the
/// table and read under either. Three exceptions: progress and worked_s are under the lock of memory only,
/// and run belongs to the worker while it holds the job.
struct LiveJob {
  std::string id;
  /// Of whoever asked for it; its log names the job. With the number of the lease while this process has it.
  store::RequestContext context;
  store::JobRow row;  ///< without the document
  store::JobState state = store::JobState::kQueued;
  bool held = false;         ///< a worker has it
  bool suspect = false;      ///< may have crashed its holder: runs alone until it has come further
  bool stepping = false;     ///< it runs to its next frame only
  bool wanted_away = false;  ///< another process has paused it: its lease is to be given up
  JobProgress progress;      ///< as the worker told it last
  std::chrono::steady_clock::time_point waits_since;  ///< when it came to stand in the queue last
  std::unique_ptr<JobRun> run;                        ///< begun, maybe parked, maybe put aside
  bool aside = false;                                 ///< it has left memory, and waits as its checkpoint
  double loads_in_s = 0;  ///< processor time that it took to take it up when it was aside last
  double worked_s = 0;    ///< processor time, as the row's at its last change and since
  std::shared_ptr<std::atomic<bool>> interrupt = std::make_shared<std::atomic<bool>>(false);

  std::shared_ptr<TouchInbox> hands = std::make_shared<TouchInbox>();
  std::shared_ptr<ShapeWish> shape = std::make_shared<ShapeWish>();

  /// This process has the lease, and the drape if there is one.
  bool is_here() const { return context.lease != 0; }
  bool is_in_memory() const { return run != nullptr && !aside; }
  /// What taking it up costs, s, as far as it is known.
  double load_s() const { return aside ? loads_in_s : 0; }
};
using LiveJobPtr = std::shared_ptr<LiveJob>;

}  // namespace toile::jobs
