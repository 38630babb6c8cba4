#pragma once
// The service of jobs over a queue in memory and a store that other processes may share. What people ask for
// is in service.cpp, what processes do beside one another in company.cpp, what workers do in working.cpp.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "server/jobs/queue_places.h"
#include "server/jobs/recovery.h"
#include "server/jobs/render_worker.h"
#include "server/jobs/row_edits.h"
#include "server/jobs/runner.h"
#include "server/jobs/service.h"
#include "server/jobs/table.h"
#include "server/jobs/transition.h"
#include "server/jobs/worker_pool.h"

namespace toile::jobs {

class QueueingJobService final : public JobService {
 public:
  QueueingJobService(documents::Documents& documents, Publisher& publisher,
                     const JobServiceSettings& settings, const Log& log)
      : documents_(documents),
        store_(documents.store()),
        publisher_(publisher),
        settings_(settings),
        log_(log),
        table_(store_, publisher),
        places_(settings.max_queued, [this] {
          const Counts now = table_.counts();
          return now.queued + now.paused;  // what is paused comes back
        }) {}
  ~QueueingJobService() override { stop(); }

  Status start() override;
  void stop() override;
  Result<store::Made<store::JobRow>> submit(const store::RequestContext& context,
                                            const std::string& project_id, const std::string& idempotency_key,
                                            const JobWish& wish) override;
  Result<store::Made<store::JobRow>> retry(const store::RequestContext& context, const std::string& id,
                                           const std::string& idempotency_key) override;
  Result<store::Made<store::SweptJobs>> submit_sweep(const store::RequestContext& context,
                                                     const SweepWish& wish,
                                                     const std::string& idempotency_key) override;
  Result<store::JobRow> pause(const store::RequestContext& context, const std::string& id) override;
  Result<store::JobRow> resume(const store::RequestContext& context, const std::string& id) override;
  Result<store::JobRow> cancel(const store::RequestContext& context, const std::string& id) override;
  Result<store::JobRow> step(const store::RequestContext& context, const std::string& id) override;
  Result<store::Made<store::JobRow>> go_on(const store::RequestContext& context, const std::string& id,
                                           const std::string& idempotency_key) override;
  Status touch(const store::RequestContext& context, const std::string& id, LiveTouch touch) override;
  Status remove(const store::RequestContext& context, const std::string& id) override;
  Result<JobProgress> progress(const store::RequestContext& context, const std::string& id) override;
  Counts counts() const override { return table_.counts(); }

 private:
  using Changing = JobTable::Changing;

  Result<store::JobRow> on_request(const store::RequestContext& context, const std::string& id,
                                   JobEvent event, const RowEdit& edit, bool one_frame = false);
  Error refusal(const store::RequestContext& context, const std::string& id, JobEvent event);
  Status check_parking(const Changing& changing, const LiveJob& job) const;
  /// How the garment of a job hangs just now; empty: it does not yet.
  struct HangsNow {
    std::string shape;
    bool for_good = false;  ///< it has come to its end, and only pictures are missing
  };
  Result<HangsNow> shape_now(const store::RequestContext& context, const LiveJobPtr& job);
  Result<store::Made<store::JobRow>> queue(const store::RequestContext& context, store::JobRow row,
                                           const std::string& idempotency_key, bool anew);
  store::JobRow take_in(const store::RequestContext& context, store::JobRow made, bool anew);
  store::JobRow begin(const Changing& changing, const store::RequestContext& context,
                      const store::JobRow& made, bool anew);
  std::optional<store::JobRow> answered(const Changing& changing, const store::RequestContext& context,
                                        const store::JobRow& job);

  Status take_up_all();
  Status take_over(const Changing& changing, bool own);
  void meet(const Changing& changing, const store::Store::OwnedJob& found);
  void meet_again(const Changing& changing, const LiveJobPtr& job, const store::JobRow& row);
  void refresh(const Changing& changing, const LiveJobPtr& job);
  void look_round();
  void beat();
  void keep_company(const std::stop_token& stop, std::int64_t seen);
  store::RequestContext context_of(const store::Store::OwnedJob& found) const;
  void forget_checkpoint(const LiveJob& job);
  void give_back_all();
  void give_back(const Changing& changing, LiveJob& job, std::unique_ptr<JobRun>& run);
  void give_away(const Changing& changing, LiveJob& job, std::unique_ptr<JobRun>& run);

  bool work_once(WorkerKind kind);
  LiveJobPtr claim(WorkerKind kind);
  Status claim(const Changing& changing, const LiveJobPtr& job);
  void forget_results(const LiveJob& job);
  void come_further(const LiveJobPtr& job);
  Status keep_draped(const LiveJobPtr& job, const RunEnd& end);
  void let_go(const LiveJobPtr& job, const std::optional<RunEnd>& run_end);
  void end_step(const Changing& changing, LiveJob& job);
  void end(const Changing& changing, const LiveJobPtr& job, const RunEnd& run_end);

  documents::Documents& documents_;
  store::Store& store_;
  Publisher& publisher_;
  const JobServiceSettings settings_;
  const Log log_;
  JobTable table_;
  QueuePlaces places_;

  std::mutex lifecycle_mutex_;  ///< start and stop; before the table's locks
  std::unique_ptr<RenderWorker> renderer_;
  std::atomic<int> working_{0};  ///< workers that have a drape in hand
  std::unique_ptr<WorkerPool> pool_, express_;
  std::mutex company_mutex_;
  std::condition_variable_any company_bell_;
  std::jthread company_;  ///< keeps leases and looks what other processes do
};

}  // namespace toile::jobs
