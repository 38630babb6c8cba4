#pragma once
// A store in memory, for tests of what stands on a store. Its calls can be made to fail.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <mutex>
#include <utility>

#include "server/store/store.h"

namespace toile::test {

class FakeStore final : public Store {
 public:
  explicit FakeStore(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~FakeStore() override { std::filesystem::remove_all(folder_); }

  /// Called before a result is put or a row is written; may throw, or give an error.
  std::function<Status(const std::string& name)> on_put_result;
  std::function<Status(const JobRow&)> on_update_job;
  std::function<Status(const std::string& job_id)> on_put_checkpoint;

  Result<AssetRow> put_asset(const RequestContext& context, AssetRow row, std::string_view bytes) override {
    const std::lock_guard lock(mutex_);
    row.id = next_id("a_");
    row.size = static_cast<std::int64_t>(bytes.size());
    const std::filesystem::path path =
        folder_ / (row.id + std::filesystem::path(row.name).extension().string());
    std::ofstream(path, std::ios::binary) << bytes;
    assets_[{context.owner, row.id}] = {row, std::string(bytes), path.string()};
    return row;
  }
  Result<AssetRow> asset(const RequestContext& context, const std::string& id) override {
    return one<AssetRow>(assets_, context, id, [](const Asset& a) { return a.row; });
  }
  Result<std::string> asset_bytes(const RequestContext& context, const std::string& id) override {
    return one<std::string>(assets_, context, id, [](const Asset& a) { return a.bytes; });
  }
  Result<std::string> asset_path(const RequestContext& context, const std::string& id) override {
    return one<std::string>(assets_, context, id, [](const Asset& a) { return a.path; });
  }
  Result<std::vector<AssetRow>> assets(const RequestContext&, const std::string&) override {
    return std::vector<AssetRow>();
  }

  Result<Made<ProjectRow>> create_project(const RequestContext& context, ProjectRow row,
                                          const std::string&) override {
    const std::lock_guard lock(mutex_);
    row.id = next_id("p_");
    projects_[{context.owner, row.id}] = row;
    return Made<ProjectRow>{row, true};
  }
  Result<ProjectRow> replace_project(const RequestContext& context, const ProjectRow& row, int) override {
    const std::lock_guard lock(mutex_);
    projects_[{context.owner, row.id}] = row;
    return row;
  }
  Result<ProjectRow> project(const RequestContext& context, const std::string& id) override {
    return one<ProjectRow>(projects_, context, id, [](const ProjectRow& row) { return row; });
  }
  Result<std::vector<ProjectRow>> projects(const RequestContext&, const std::string&, int) override {
    return std::vector<ProjectRow>();
  }
  Status remove_project(const RequestContext& context, const std::string& id, int) override {
    const std::lock_guard lock(mutex_);
    projects_.erase({context.owner, id});
    return {};
  }

  Result<ProjectRow> edit_project(const RequestContext& context, const ProjectRow& row, int expected,
                                  EditStep, const EditRow&) override {
    return replace_project(context, row, expected);
  }
  Result<std::vector<EditRow>> edits(const RequestContext&, const std::string&, std::int64_t, int) override {
    return std::vector<EditRow>();
  }
  Result<std::optional<EditRow>> next_edit(const RequestContext&, const std::string&, EditStep) override {
    return std::optional<EditRow>();
  }

  Result<Made<JobRow>> create_job(const RequestContext& context, JobRow row,
                                  const std::string& key) override {
    const std::lock_guard lock(mutex_);
    if (const auto made = keys_.find({context.owner, key}); made != keys_.end()) {
      return Made<JobRow>{jobs_.at({context.owner, made->second}), false};
    }
    row.id = next_id("j_");
    row.created_ms = count_;
    jobs_[{context.owner, row.id}] = row;
    if (!key.empty()) keys_[{context.owner, key}] = row.id;
    return Made<JobRow>{row, true};
  }
  Result<std::optional<JobRow>> job_of_key(const RequestContext& context, const std::string& key) override {
    const std::lock_guard lock(mutex_);
    const auto made = keys_.find({context.owner, key});
    return made == keys_.end() ? std::optional<JobRow>()
                               : std::optional(jobs_.at({context.owner, made->second}));
  }
  Result<JobRow> job(const RequestContext& context, const std::string& id) override {
    return one<JobRow>(jobs_, context, id, [](const JobRow& row) { return row; });
  }
  Result<std::vector<JobRow>> jobs(const RequestContext&, const std::string&, int) override {
    return std::vector<JobRow>();
  }
  Status update_job(const RequestContext& context, const JobRow& row) override {
    if (on_update_job) {
      if (Status refused = on_update_job(row); !refused) return refused;
    }
    const std::lock_guard lock(mutex_);
    const auto found = jobs_.find({context.owner, row.id});
    if (found == jobs_.end()) return Error{"store.not_found", "", "", ErrorKind::kNotFound};
    JobRow& kept = found->second;
    kept.state = row.state;
    kept.attempt = row.attempt;
    kept.reason_code = row.reason_code;
    kept.reason = row.reason;
    kept.reason_where = row.reason_where;
    kept.started_ms = row.started_ms;
    kept.ended_ms = row.ended_ms;
    kept.report = row.report;
    kept.results = row.results;
    return {};
  }
  Result<std::vector<OwnedJob>> unfinished_jobs() override {
    const std::lock_guard lock(mutex_);
    std::vector<OwnedJob> found;
    for (const auto& [key, row] : jobs_) {
      if (!is_final(row.state)) {
        found.push_back({key.first, row});
      }
    }
    return found;
  }

  Status put_result(const RequestContext& context, const std::string& job_id, const std::string& name,
                    std::string_view bytes) override {
    if (on_put_result) {
      if (Status refused = on_put_result(name); !refused) return refused;
    }
    const std::lock_guard lock(mutex_);
    results_[{context.owner, job_id + "/" + name}] = bytes;
    return {};
  }
  Result<std::string> result_bytes(const RequestContext& context, const std::string& job_id,
                                   const std::string& name) override {
    return one<std::string>(results_, context, job_id + "/" + name,
                            [](const std::string& bytes) { return bytes; });
  }
  Status remove_results(const RequestContext& context, const std::string& job_id) override {
    const std::lock_guard lock(mutex_);
    std::erase_if(results_, [&](const auto& result) {
      return result.first.first == context.owner && result.first.second.starts_with(job_id + "/");
    });
    return {};
  }
  /// Files of results of a job that are kept, named or not.
  std::size_t kept_results(const RequestContext& context, const std::string& job_id) {
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(std::count_if(results_.begin(), results_.end(), [&](const auto& result) {
      return result.first.first == context.owner && result.first.second.starts_with(job_id + "/");
    }));
  }
  Status put_checkpoint(const RequestContext& context, const std::string& job_id,
                        std::string_view bytes) override {
    if (on_put_checkpoint) {
      if (Status refused = on_put_checkpoint(job_id); !refused) return refused;
    }
    using namespace std::chrono;
    const std::lock_guard lock(mutex_);
    checkpoints_[{context.owner, job_id}] = {
        std::string(bytes), duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count()};
    ++checkpoints_put_;
    return {};
  }
  Result<KeptCheckpoint> checkpoint(const RequestContext& context, const std::string& job_id) override {
    return one<KeptCheckpoint>(checkpoints_, context, job_id,
                               [](const KeptCheckpoint& kept) { return kept; });
  }
  Status remove_checkpoint(const RequestContext& context, const std::string& job_id) override {
    const std::lock_guard lock(mutex_);
    checkpoints_.erase({context.owner, job_id});
    return {};
  }
  /// How many were ever put.
  int checkpoints_put() {
    const std::lock_guard lock(mutex_);
    return checkpoints_put_;
  }

  Result<std::optional<std::string>> get_setting(const RequestContext&, const std::string&) override {
    return std::optional<std::string>();
  }
  Status put_setting(const RequestContext&, const std::string&, const std::string&) override { return {}; }
  std::string scratch_folder() const override { return folder_.string(); }
  Status ping() override { return {}; }

  /// Changes a job's row behind the service's back, as a crash or another program would.
  void tamper(const RequestContext& context, const std::string& id,
              const std::function<void(JobRow&)>& edit) {
    const std::lock_guard lock(mutex_);
    edit(jobs_.at({context.owner, id}));
  }

 private:
  using Key = std::pair<OwnerId, std::string>;
  struct Asset {
    AssetRow row;
    std::string bytes, path;
  };

  /// Rises, so that the order of ids is that of making.
  std::string next_id(const char* prefix) {
    char text[24];
    std::snprintf(text, sizeof text, "%s%08d", prefix, ++count_);
    return text;
  }

  template <typename Out, typename Map, typename Read>
  Result<Out> one(const Map& map, const RequestContext& context, const std::string& id, Read read) {
    const std::lock_guard lock(mutex_);
    const auto found = map.find({context.owner, id});
    if (found == map.end())
      return Error{"store.not_found", "there is no such thing", "", ErrorKind::kNotFound};
    return read(found->second);
  }

  std::filesystem::path folder_;
  std::mutex mutex_;
  int count_ = 0;
  std::map<Key, Asset> assets_;
  std::map<Key, ProjectRow> projects_;
  std::map<Key, JobRow> jobs_;
  std::map<Key, std::string> keys_, results_;
  std::map<Key, KeptCheckpoint> checkpoints_;
  int checkpoints_put_ = 0;
};

}  // namespace toile::test
