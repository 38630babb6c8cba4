#pragma once
// The store on one machine: a SQLite database and folders of files. Internal to the store.

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/store/blobs.h"
#include "server/store/folder_lock.h"
#include "server/store/ids.h"
#include "server/store/sqlite/database.h"
#include "server/store/store.h"

namespace toile {

/// Where an asset's bytes lie: its blob and size.
struct BlobPlace {
  std::string blob;
  std::int64_t size = 0;
};

class SqliteStore final : public Store {
 public:
  SqliteStore(FolderLock lock, Blobs blobs, SqlDatabase database, IdSource ids)
      : lock_(std::move(lock)), blobs_(std::move(blobs)), database_(std::move(database)), ids_(ids) {}

  Result<AssetRow> put_asset(const RequestContext& context, AssetRow row, std::string_view bytes) override;
  Result<AssetRow> asset(const RequestContext& context, const std::string& id) override;
  Result<std::string> asset_bytes(const RequestContext& context, const std::string& id) override;
  Result<std::string> asset_path(const RequestContext& context, const std::string& id) override;
  Result<std::vector<AssetRow>> assets(const RequestContext& context, const std::string& kind) override;

  Result<Made<ProjectRow>> create_project(const RequestContext& context, ProjectRow row,
                                          const std::string& idempotency_key) override;
  Result<ProjectRow> replace_project(const RequestContext& context, const ProjectRow& row,
                                     int expected) override;
  Result<ProjectRow> project(const RequestContext& context, const std::string& id) override;
  Result<std::vector<ProjectRow>> projects(const RequestContext& context, const std::string& cursor,
                                           int limit) override;
  Status remove_project(const RequestContext& context, const std::string& id, int expected) override;

  Result<ProjectRow> edit_project(const RequestContext& context, const ProjectRow& row, int expected,
                                  EditStep step, const EditRow& edit) override;
  Result<std::vector<EditRow>> edits(const RequestContext& context, const std::string& project_id,
                                     std::int64_t before, int limit) override;
  Result<std::optional<EditRow>> next_edit(const RequestContext& context, const std::string& project_id,
                                           EditStep step) override;

  Result<Made<JobRow>> create_job(const RequestContext& context, JobRow row,
                                  const std::string& idempotency_key) override;
  Result<std::optional<JobRow>> job_of_key(const RequestContext& context,
                                           const std::string& idempotency_key) override;
  Result<JobRow> job(const RequestContext& context, const std::string& id) override;
  Result<std::vector<JobRow>> jobs(const RequestContext& context, const std::string& cursor,
                                   int limit) override;
  Status update_job(const RequestContext& context, const JobRow& row) override;
  Result<std::vector<OwnedJob>> unfinished_jobs() override;

  Status put_result(const RequestContext& context, const std::string& job_id, const std::string& name,
                    std::string_view bytes) override;
  Result<std::string> result_bytes(const RequestContext& context, const std::string& job_id,
                                   const std::string& name) override;
  Status remove_results(const RequestContext& context, const std::string& job_id) override;

  Status put_checkpoint(const RequestContext& context, const std::string& job_id,
                        std::string_view bytes) override;
  Result<KeptCheckpoint> checkpoint(const RequestContext& context, const std::string& job_id) override;
  Status remove_checkpoint(const RequestContext& context, const std::string& job_id) override;

  Result<std::optional<std::string>> get_setting(const RequestContext& context,
                                                 const std::string& key) override;
  Status put_setting(const RequestContext& context, const std::string& key,
                     const std::string& value) override;
  std::string scratch_folder() const override { return blobs_.scratch_folder().string(); }
  Status ping() override;

 private:
  // What follows expects mutex_ to be held.
  Result<ProjectRow> find_project(const OwnerId& owner, const std::string& id);
  Status insert_job(const OwnerId& owner, const JobRow& row, const std::string& idempotency_key);
  Result<std::optional<ProjectRow>> project_of_key(const OwnerId& owner, const std::string& key,
                                                   const std::string& request);
  Status insert_project(const OwnerId& owner, const ProjectRow& row);
  Result<ProjectRow> update_project(const OwnerId& owner, const ProjectRow& now, const ProjectRow& row);
  Status append_edit(const OwnerId& owner, const std::string& project_id, const EditRow& edit);
  Status turn_edit(const OwnerId& owner, const std::string& project_id, std::int64_t number, bool undone);
  Status trim_edits(const OwnerId& owner, const std::string& project_id);
  Status forget_edits(const OwnerId& owner, const std::string& project_id);
  Result<std::optional<JobRow>> find_job_of_key(const OwnerId& owner, const std::string& key);

  // And what follows takes it.
  Result<BlobPlace> blob_place(const OwnerId& owner, const std::string& id);
  Status check_job(const OwnerId& owner, const std::string& id);

  const FolderLock lock_;
  const Blobs blobs_;
  std::mutex mutex_;  // guards what stands below; files are read and written without it
  SqlDatabase database_;
  IdSource ids_;
};

/// Now, as Unix time.
std::int64_t store_now_ms();
/// That the project stands at the revision that somebody has seen; 0 stands for any. Error: store.conflict.
Status check_revision(const ProjectRow& now, int expected);
/// One more than any id when the cursor is empty, so that "before the cursor" is everything. Error:
/// store.cursor.
Result<std::string> before_what(const std::string& cursor, char letter);
/// Error: store.idempotency_key.
Status check_key(const std::string& key);
/// How many rows a page may have, of those asked for.
std::int64_t page_limit(int limit);

}  // namespace toile
