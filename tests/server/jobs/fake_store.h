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

class FakeStore final : public store::Store {
 public:
  explicit FakeStore(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~FakeStore() override { std::filesystem::remove_all(folder_); }

  /// Called before a result is put or a row is written; may throw, or give an error.
  std::function<Status(const std::string& name)> on_put_result;
  std::function<Status(const store::JobRow&)> on_update_job;
  std::function<Status(const std::string& job_id)> on_put_checkpoint;

  Result<store::AssetRow> put_asset(const store::RequestContext& context, store::AssetRow row,
                                    std::string_view bytes) override {
    const std::lock_guard lock(mutex_);
    row.id = next_id("a_");
    row.size = static_cast<std::int64_t>(bytes.size());
    const std::filesystem::path path =
        folder_ / (row.id + std::filesystem::path(row.name).extension().string());
    std::ofstream(path, std::ios::binary) << bytes;
    assets_[{context.owner, row.id}] = {row, std::string(bytes), path.string()};
    return row;
  }
  Result<store::AssetRow> asset(const store::RequestContext& context, const std::string& id) override {
    return one<store::AssetRow>(assets_, context, id, [](const Asset& a) { return a.row; });
  }
  Result<std::string> asset_bytes(const store::RequestContext& context, const std::string& id) override {
    return one<std::string>(assets_, context, id, [](const Asset& a) { return a.bytes; });
  }
  Result<std::string> asset_path(const store::RequestContext& context, const std::string& id) override {
    return one<std::string>(assets_, context, id, [](const Asset& a) { return a.path; });
  }
  Result<std::vector<store::AssetRow>> assets(const store::RequestContext&, const std::string&) override {
    return std::vector<store::AssetRow>();
  }
  Status remove_asset(const store::RequestContext&, const std::string&) override { return {}; }

  Result<store::Made<store::ProjectRow>> create_project(const store::RequestContext& context,
                                                        store::ProjectRow row, const std::string&) override {
    const std::lock_guard lock(mutex_);
    row.id = next_id("p_");
    projects_[{context.owner, row.id}] = row;
    return store::Made<store::ProjectRow>{row, true};
  }
  Result<store::ProjectRow> replace_project(const store::RequestContext& context,
                                            const store::ProjectRow& row, int) override {
    const std::lock_guard lock(mutex_);
    projects_[{context.owner, row.id}] = row;
    return row;
  }
  Result<store::ProjectRow> project(const store::RequestContext& context, const std::string& id) override {
    return one<store::ProjectRow>(projects_, context, id, [](const store::ProjectRow& row) { return row; });
  }
  Result<std::vector<store::ProjectRow>> projects(const store::RequestContext&, const std::string&,
                                                  int) override {
    return std::vector<store::ProjectRow>();
  }
  Status remove_project(const store::RequestContext& context, const std::string& id, int) override {
    const std::lock_guard lock(mutex_);
    projects_.erase({context.owner, id});
    return {};
  }

  Result<store::ProjectRow> edit_project(const store::RequestContext& context, const store::ProjectRow& row,
                                         int expected, store::EditStep, const store::EditRow&) override {
    return replace_project(context, row, expected);
  }
  Result<std::vector<store::EditRow>> edits(const store::RequestContext&, const std::string&, std::int64_t,
                                            int) override {
    return std::vector<store::EditRow>();
  }
  Result<std::optional<store::EditRow>> next_edit(const store::RequestContext&, const std::string&,
                                                  store::EditStep) override {
    return std::optional<store::EditRow>();
  }

  Result<store::Made<store::JobRow>> create_job(const store::RequestContext& context, store::JobRow row,
                                                const std::string& key) override {
    const std::lock_guard lock(mutex_);
    if (const auto made = keys_.find({context.owner, key}); made != keys_.end()) {
      return store::Made<store::JobRow>{jobs_.at({context.owner, made->second}), false};
    }
    row.id = next_id("j_");
    row.created_ms = count_;
    jobs_[{context.owner, row.id}] = row;
    if (!key.empty()) keys_[{context.owner, key}] = row.id;
    return store::Made<store::JobRow>{row, true};
  }
  Result<std::optional<store::JobRow>> job_of_key(const store::RequestContext& context,
                                                  const std::string& key) override {
    const std::lock_guard lock(mutex_);
    const auto made = keys_.find({context.owner, key});
    return made == keys_.end() ? std::optional<store::JobRow>()
                               : std::optional(jobs_.at({context.owner, made->second}));
  }
  Result<store::JobRow> job(const store::RequestContext& context, const std::string& id) override {
    return one<store::JobRow>(jobs_, context, id, [](const store::JobRow& row) { return row; });
  }
  Result<std::vector<store::JobRow>> jobs(const store::RequestContext&, const std::string&, int) override {
    return std::vector<store::JobRow>();
  }
  Result<std::vector<std::string>> jobs_of_project(const store::RequestContext&,
                                                   const std::string&) override {
    return std::vector<std::string>();
  }
  Status remove_job(const store::RequestContext& context, const std::string& id) override {
    const std::lock_guard lock(mutex_);
    jobs_.erase({context.owner, id});
    return {};
  }
  Result<store::JobRow> change_job(const store::RequestContext& context, const std::string& id,
                                   const JobEdit& edit) override {
    const std::lock_guard changing(change_mutex_);
    store::JobRow row = TRY(job(context, id));
    if (context.lease != 0 && context.lease != row.lease.number) return store::lease_lost();
    TRY(edit(row));
    if (on_update_job) {
      if (Status refused = on_update_job(row); !refused) return refused.error();
    }
    const std::lock_guard lock(mutex_);
    jobs_.at({context.owner, id}) = row;
    return row;
  }
  std::string holder() const override { return "h_fake"; }
  Result<std::vector<OwnedJob>> take_from_the_gone(std::int64_t, bool own, const JudgeJob& judge) override {
    std::vector<OwnedJob> left;
    const std::vector<OwnedJob> all = TRY(unfinished_jobs());
    for (const OwnedJob& owned : all) {
      const bool runs = owned.job.state == store::JobState::kRunning;
      if (owned.job.lease.holder.empty() ? runs : own) left.push_back(owned);
    }
    const auto running = std::count_if(left.begin(), left.end(), [](const OwnedJob& owned) {
      return owned.job.state == store::JobState::kRunning;
    });
    for (OwnedJob& owned : left) {
      const auto kept = checkpoint(store::RequestContext(owned.owner), owned.job.id);
      owned.job.lease.holder.clear();
      LeftJob one{owned, static_cast<int>(running), kept ? kept->kept_ms : 0};
      judge(one);
      owned = one.owned;
      if (on_update_job) {
        if (Status refused = on_update_job(owned.job); !refused) return refused.error();
      }
      const std::lock_guard lock(mutex_);
      jobs_.at({owned.owner, owned.job.id}) = owned.job;
    }
    return left;
  }
  std::int64_t changes_by_others() override { return 0; }
  Result<std::vector<OwnedJob>> unfinished_jobs() override {
    const std::lock_guard lock(mutex_);
    std::vector<OwnedJob> found;
    for (const auto& [key, row] : jobs_) {
      if (!store::is_final(row.state)) {
        found.push_back({key.first, row});
      }
    }
    return found;
  }

  Result<std::optional<store::JobRow>> succeeded_job_of_input(const store::RequestContext& context,
                                                              const std::string& input) override {
    const std::lock_guard lock(mutex_);
    std::optional<store::JobRow> found;
    for (const auto& [key, row] : jobs_) {
      const bool equal = key.first == context.owner && !input.empty() && row.input == input;
      if (equal && row.state == store::JobState::kSucceeded) found = row;
    }
    return found;
  }
  /// Asked before results are shared; may give an error.
  std::function<Status()> on_share_results;
  Status share_results(const store::RequestContext& context, const std::string& from,
                       const std::string& to) override {
    if (on_share_results) {
      if (Status refused = on_share_results(); !refused) return refused;
    }
    const std::lock_guard lock(mutex_);
    for (const auto& [name, file] : jobs_.at({context.owner, from}).results)
      results_[{context.owner, to + "/" + name}] = results_.at({context.owner, from + "/" + name});
    return {};
  }
  Status put_result(const store::RequestContext& context, const std::string& job_id, const std::string& name,
                    std::string_view bytes) override {
    if (on_put_result) {
      if (Status refused = on_put_result(name); !refused) return refused;
    }
    const std::lock_guard lock(mutex_);
    results_[{context.owner, job_id + "/" + name}] = bytes;
    return {};
  }
  Result<std::string> result_bytes(const store::RequestContext& context, const std::string& job_id,
                                   const std::string& name) override {
    return one<std::string>(results_, context, job_id + "/" + name,
                            [](const std::string& bytes) { return bytes; });
  }
  Result<std::string> result_path(const store::RequestContext&, const std::string&,
                                  const std::string&) override {
    return Error{"store.not_found", "results lie in memory here", "", ErrorKind::kNotFound};
  }
  Status remove_results(const store::RequestContext& context, const std::string& job_id) override {
    const std::lock_guard lock(mutex_);
    std::erase_if(results_, [&](const auto& result) {
      return result.first.first == context.owner && result.first.second.starts_with(job_id + "/");
    });
    return {};
  }
  /// Files of results of a job that are kept, named or not.
  std::size_t kept_results(const store::RequestContext& context, const std::string& job_id) {
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(std::count_if(results_.begin(), results_.end(), [&](const auto& result) {
      return result.first.first == context.owner && result.first.second.starts_with(job_id + "/");
    }));
  }
  Status put_checkpoint(const store::RequestContext& context, const std::string& job_id,
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
  Result<KeptCheckpoint> checkpoint(const store::RequestContext& context,
                                    const std::string& job_id) override {
    return one<KeptCheckpoint>(checkpoints_, context, job_id,
                               [](const KeptCheckpoint& kept) { return kept; });
  }
  Status remove_checkpoint(const store::RequestContext& context, const std::string& job_id) override {
    const std::lock_guard lock(mutex_);
    checkpoints_.erase({context.owner, job_id});
    return {};
  }
  /// How many were ever put.
  int checkpoints_put() {
    const std::lock_guard lock(mutex_);
    return checkpoints_put_;
  }

  Result<std::optional<std::string>> get_setting(const store::RequestContext&, const std::string&) override {
    return std::optional<std::string>();
  }
  Status put_setting(const store::RequestContext&, const std::string&, const std::string&) override {
    return {};
  }
  Result<std::vector<store::OwnedId>> jobs_ended_before(std::int64_t unix_ms, int) override {
    const std::lock_guard lock(mutex_);
    std::vector<store::OwnedId> found;
    for (const auto& [key, row] : jobs_) {
      if (store::is_final(row.state) && row.ended_ms < unix_ms) found.push_back({key.first, key.second});
    }
    return found;
  }
  Result<std::vector<store::OwnedId>> unused_assets(std::int64_t) override {
    return std::vector<store::OwnedId>();
  }
  Result<store::Usage> usage(const store::RequestContext&) override { return store::Usage(); }
  std::string log_folder() const override { return folder_.string(); }
  Result<std::string> job_log(const store::RequestContext&, const std::string&) override {
    return std::string();
  }
  store::StoreFigures figures() const override { return {}; }
  std::string scratch_folder() const override { return folder_.string(); }
  Status ping() override { return {}; }

  /// Changes a job's row behind the service's back, as a crash or another program would.
  void tamper(const store::RequestContext& context, const std::string& id,
              const std::function<void(store::JobRow&)>& edit) {
    const std::lock_guard lock(mutex_);
    edit(jobs_.at({context.owner, id}));
  }

 private:
  using Key = std::pair<store::OwnerId, std::string>;
  struct Asset {
    store::AssetRow row;
    std::string bytes, path;
  };

  /// Rises, so that the order of ids is that of making.
  std::string next_id(const char* prefix) {
    char text[24];
    std::snprintf(text, sizeof text, "%s%08d", prefix, ++count_);
    return text;
  }

  template <typename Out, typename Map, typename Read>
  Result<Out> one(const Map& map, const store::RequestContext& context, const std::string& id, Read read) {
    const std::lock_guard lock(mutex_);
    const auto found = map.find({context.owner, id});
    if (found == map.end())
      return Error{"store.not_found", "there is no such thing", "", ErrorKind::kNotFound};
    return read(found->second);
  }

  std::filesystem::path folder_;
  std::mutex change_mutex_;  // before mutex_
  std::mutex mutex_;
  int count_ = 0;
  std::map<Key, Asset> assets_;
  std::map<Key, store::ProjectRow> projects_;
  std::map<Key, store::JobRow> jobs_;
  std::map<Key, std::string> keys_, results_;
  std::map<Key, KeptCheckpoint> checkpoints_;
  int checkpoints_put_ = 0;
};

}  // namespace toile::test
