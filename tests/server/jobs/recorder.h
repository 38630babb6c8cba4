#pragma once
// A publisher that writes down what it is told.

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>

#include "server/jobs/publisher.h"

namespace toile::test {

class Recorder final : public Publisher {
 public:
  using Clock = std::chrono::steady_clock;
  struct Told {
    Clock::time_point at;
    JobProgress progress;
  };
  struct JobLog {
    std::string order;  ///< T topology, F frame, p progress, e ended
    std::vector<std::shared_ptr<const StreamTopology>> topologies;
    std::vector<std::shared_ptr<const StreamFrame>> frames;
    std::vector<Told> progress;
    std::vector<JobProgress> ended;
  };

  /// May throw; called before the frame is written down.
  std::function<void(const std::string& job_id)> on_frame;

  void topology(const std::string& id, std::shared_ptr<const StreamTopology> topology) override {
    write(id, 'T', [&](JobLog& log) { log.topologies.push_back(std::move(topology)); });
  }
  void frame(const std::string& id, std::shared_ptr<const StreamFrame> frame) override {
    if (on_frame) on_frame(id);
    write(id, 'F', [&](JobLog& log) { log.frames.push_back(std::move(frame)); });
  }
  void progress(const std::string& id, const JobProgress& progress) override {
    write(id, 'p', [&](JobLog& log) { log.progress.push_back({Clock::now(), progress}); });
  }
  void ended(const std::string& id, const JobProgress& last) override {
    write(id, 'e', [&](JobLog& log) { log.ended.push_back(last); });
  }

  JobLog log(const std::string& id) const {
    const std::lock_guard lock(mutex_);
    const auto found = logs_.find(id);
    return found == logs_.end() ? JobLog{} : found->second;
  }

  /// Waits until `holds` of the job's log; false after five minutes, when nothing will come any more.
  bool wait(const std::string& id, const std::function<bool(const JobLog&)>& holds) const {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::minutes(5), [&] {
      const auto found = logs_.find(id);
      return found != logs_.end() && holds(found->second);
    });
  }
  bool wait_for_end(const std::string& id, std::size_t times = 1) const {
    return wait(id, [&](const JobLog& log) { return log.ended.size() >= times; });
  }
  bool wait_for_frames(const std::string& id, std::size_t count) const {
    return wait(id, [&](const JobLog& log) { return log.frames.size() >= count; });
  }
  /// Until the newest that was told is that state.
  bool wait_for_state(const std::string& id, JobState state) const {
    return wait(id, [&](const JobLog& log) {
      return !log.progress.empty() && log.progress.back().progress.state == state;
    });
  }

 private:
  void write(const std::string& id, char kind, const std::function<void(JobLog&)>& entry) {
    {
      const std::lock_guard lock(mutex_);
      logs_[id].order += kind;
      entry(logs_[id]);
    }
    changed_.notify_all();
  }

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::map<std::string, JobLog> logs_;
};

}  // namespace toile::test
