#pragma once
// The jobs that have not ended, in memory, and the one way to change them.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "server/jobs/live_job.h"
#include "server/jobs/publisher.h"
#include "server/jobs/roster.h"
#include "server/jobs/row_edits.h"
#include "server/jobs/service.h"
#include "server/jobs/tally.h"
#include "server/jobs/transition.h"
#include "server/store/store.h"

namespace toile::jobs {

/// On whose account a job is changed.
enum class By {
  kHolder,   ///< this process, under its lease: refused once another has the job
  kRequest,  ///< anybody who asks
};

/// Jobs of the store as this process knows them: those that it works on, those that wait, and those that
/// other processes work on. The store has the last word; what others have changed there comes in by adopt().
///
/// Two locks. One puts changes into an order: what a change writes to the store and tells the publisher
/// happens under it; `changing` takes it. The other guards memory only and is never held while anybody waits,
/// so that looking at jobs does not wait for the disk. What a worker tells of the job that it holds goes to
/// the publisher without a lock; nobody else tells of that job until it lets go.
class JobTable {
 public:
  using Changing = std::unique_lock<std::mutex>;

  JobTable(store::Store& store, Publisher& publisher) : store_(store), publisher_(publisher) {}

  [[nodiscard]] Changing changing() { return Changing(change_mutex_); }

  // With the order of changes held, as the first argument proves.

  /// Store first, then memory, then the workers' bell. Errors: jobs.state, those of the store; then nothing
  /// has changed.
  Status change(const Changing&, LiveJob& job, JobEvent event, const RowEdit& edit = {}, By by = By::kHolder);
  /// A worker of this process takes it: kClaim under a new lease, or under the one that it has kept with its
  /// drape. Errors: as change(); jobs.taken while another process has it.
  Status claim(const Changing&, LiveJob& job, std::chrono::milliseconds lease, const RowEdit& edit = {});
  /// Writes what this process has done on a job that is here and that no worker holds, as a heartbeat would.
  /// Errors: those of the store.
  Status tell_work(const Changing&, LiveJob& job);
  /// Gives up the lease of a job that no worker holds, and the drape; what was done on it is written.
  Status release(const Changing&, LiveJob& job, std::unique_ptr<JobRun>& run);
  /// What the store has of it, where another process may have changed it. Whether its state is another now.
  bool adopt(const Changing&, LiveJob& job, const store::JobRow& row);
  /// Its drape, where the lease is lost.
  std::unique_ptr<JobRun> drop_run(const Changing&, LiveJob& job);
  /// A job that this process works on, as its heartbeat tells it.
  struct Held {
    LiveJobPtr job;
    store::RequestContext context;
    JobProgress progress;
    double worked_s = 0;
    bool suspect = false;
  };
  std::vector<Held> held_here() const;
  /// Marks a job as failed of which the store takes no word. The next start finds it cut off.
  void fail_in_memory(const Changing&, LiveJob& job);
  /// Tells viewers the state, and that it is the last one when the job has ended or the table is closed.
  /// REQUIRES that no worker drapes the job.
  void announce(const Changing&, const LiveJob& job);
  /// A job that has ended before it was taken in.
  void count_answered(const Changing&);
  /// Takes a job in as its row has it, at the end of the queue unless it is paused. Gives back nothing when
  /// it is there already or the table is closed.
  LiveJobPtr insert(const Changing&, const store::RequestContext& context, const store::JobRow& row);
  /// It has come further: others may run beside it. Whether another suspect waits for a turn alone.
  bool clear(const Changing&, LiveJob& job);
  /// Takes a job out and gives back its drape, to be freed when the locks are not held.
  std::unique_ptr<JobRun> remove(const Changing&, const LiveJobPtr& job);
  /// Whose turn it is (JobRoster::next); nothing once the table is closed.
  LiveJobPtr next_ready(const Changing&, WorkerKind kind, int most) const;
  /// A worker has the job; without a drape it gets one from `make`, for the stream of that epoch: each lease
  /// has its own.
  void hand_out(const Changing&, LiveJob& job,
                const std::function<std::unique_ptr<JobRun>(std::uint32_t epoch)>& make);
  void take_back(const Changing&, LiveJob& job);
  /// It has made room, and waits for its next turn in memory: as running for all who look.
  void make_wait(const Changing&, LiveJob& job);
  void set_stepping(const Changing&, LiveJob& job, bool stepping);
  std::vector<LiveJobPtr> all(const Changing&) const;
  /// Jobs that are paused and whose drape lies in memory.
  int parked(const Changing&) const;

  /// Takes jobs from now on.
  void open(const Changing&);
  /// Takes no more, interrupts what workers hold, and lets them go home.
  void close(const Changing&);
  bool is_open(const Changing&) const { return open_; }

  // Without.

  LiveJobPtr find(const store::RequestContext& context, const std::string& id) const;
  JobProgress progress(const LiveJob& job) const;
  store::JobState state(const LiveJob& job) const;
  bool is_stepping(const LiveJob& job) const;
  bool is_here(const LiveJob& job) const;
  JobService::Counts counts() const;
  double worked(const LiveJob& job) const;
  /// Whether a stop has waited long enough for what could be brought to its end.
  bool is_out_of_patience() const;
  /// Waits until a job may be taken: true; or until the table is closed: false.
  bool wait_for_work(WorkerKind kind);
  /// JobRoster::room_to_make; none once the table is closed.
  MakeRoom room_to_make(const LiveJob& job, int most) const;
  /// Waits, but not for a closed table.
  void pause(std::chrono::milliseconds time);
  /// Takes down and publishes what the holder of the job tells, unless the job is not running any more.
  void hear(LiveJob& job, const JobProgress& progress);
  /// Takes down what the holder of the job has spent on it.
  void charge(LiveJob& job, std::string_view phase, double seconds);

 private:
  JobProgress progress_now(const LiveJob& job) const;
  Status write(LiveJob& job, const store::RequestContext& context, JobEvent event,
               const store::Store::JobEdit& edit);

  store::Store& store_;
  Publisher& publisher_;
  std::mutex change_mutex_;  // before mutex_
  mutable std::mutex mutex_;
  std::condition_variable bell_;
  bool open_ = false;
  std::chrono::steady_clock::time_point closed_;
  JobRoster roster_;
  JobTally tally_;
};

}  // namespace toile::jobs
