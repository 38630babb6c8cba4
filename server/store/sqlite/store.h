#pragma once
// The store on one machine: a SQLite database and folders of files. Internal to the store.

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/store/blobs.h"
#include "server/store/events.h"
#include "server/store/folder_lock.h"
#include "server/store/holders.h"
#include "server/store/ids.h"
#include "server/store/job_search.h"
#include "server/store/sqlite/accounts.h"
#include "server/store/sqlite/database.h"
#include "server/store/sqlite/group_commit.h"
#include "server/store/sqlite/links.h"
#include "server/store/store.h"
#include "server/store/sweeps.h"
#include "server/store/versions.h"
#include "server/store/webhooks.h"

namespace toile::sqlite {

/// Where an asset's bytes lie: its blob and size.
struct BlobPlace {
  std::string blob;
  std::int64_t size = 0;
};

class SqliteStore final : public store::Store,
                          public store::Events,
                          public store::Webhooks,
                          public store::JobSearch,
                          public store::Sweeps,
                          public store::Versions {
 public:
  struct Locks {
    std::optional<store::FolderLock> server;
    store::FolderLock shared;
    store::Holder holder;
  };
  /// `failures` are those that blobs and database count in.
  SqliteStore(Locks locks, store::Blobs blobs, SqlDatabase database, store::IdSource ids,
              std::shared_ptr<const store::Failures> failures, store::Quotas quotas)
      : locks_(std::move(locks)),
        failures_(std::move(failures)),
        quotas_(quotas),
        blobs_(std::move(blobs)),
        database_(std::move(database)),
        ids_(ids) {}

  Result<store::AssetRow> put_asset(const store::RequestContext& context, store::AssetRow row,
                                    std::string_view bytes) override;
  Result<store::AssetRow> asset(const store::RequestContext& context, const std::string& id) override;
  Result<std::string> asset_bytes(const store::RequestContext& context, const std::string& id) override;
  Result<std::string> asset_path(const store::RequestContext& context, const std::string& id) override;
  Result<std::vector<store::AssetRow>> assets(const store::RequestContext& context,
                                              const std::string& kind) override;
  Status remove_asset(const store::RequestContext& context, const std::string& id) override;

  Result<store::Made<store::ProjectRow>> create_project(const store::RequestContext& context,
                                                        store::ProjectRow row,
                                                        const std::string& idempotency_key) override;
  Result<store::ProjectRow> replace_project(const store::RequestContext& context,
                                            const store::ProjectRow& row, int expected) override;
  Result<store::ProjectRow> project(const store::RequestContext& context, const std::string& id) override;
  Result<std::vector<store::ProjectRow>> projects(const store::RequestContext& context,
                                                  const std::string& cursor, int limit) override;
  Status remove_project(const store::RequestContext& context, const std::string& id, int expected) override;

  Result<store::ProjectRow> edit_project(const store::RequestContext& context, const store::ProjectRow& row,
                                         int expected, store::EditStep step,
                                         const store::EditRow& edit) override;
  Result<std::vector<store::EditRow>> edits(const store::RequestContext& context,
                                            const std::string& project_id, std::int64_t before,
                                            int limit) override;
  Result<std::optional<store::EditRow>> next_edit(const store::RequestContext& context,
                                                  const std::string& project_id,
                                                  store::EditStep step) override;

  Result<store::Made<store::JobRow>> create_job(const store::RequestContext& context, store::JobRow row,
                                                const std::string& idempotency_key) override;
  Result<std::optional<store::JobRow>> job_of_key(const store::RequestContext& context,
                                                  const std::string& idempotency_key) override;
  Result<store::JobRow> job(const store::RequestContext& context, const std::string& id) override;
  Result<std::vector<store::JobRow>> jobs(const store::RequestContext& context, const std::string& cursor,
                                          int limit) override;
  Result<std::optional<store::JobRow>> succeeded_job_of_input(const store::RequestContext& context,
                                                              const std::string& input) override;
  Result<std::vector<std::string>> jobs_of_project(const store::RequestContext& context,
                                                   const std::string& project_id) override;
  Status remove_job(const store::RequestContext& context, const std::string& id) override;
  Result<store::JobRow> change_job(const store::RequestContext& context, const std::string& id,
                                   const JobEdit& edit) override;
  Result<std::vector<OwnedJob>> unfinished_jobs() override;
  std::string holder() const override { return locks_.holder.id(); }
  Result<std::vector<OwnedJob>> take_from_the_gone(std::int64_t now_ms, bool own,
                                                   const JudgeJob& judge) override;
  std::int64_t changes_by_others() override;
  Result<std::vector<store::OwnedId>> jobs_ended_before(std::int64_t unix_ms, int limit) override;
  Result<std::vector<store::OwnedId>> unused_assets(std::int64_t before_ms) override;
  Result<store::Usage> usage(const store::RequestContext& context) override;

  Status put_result(const store::RequestContext& context, const std::string& job_id, const std::string& name,
                    std::string_view bytes) override;
  Result<std::string> result_bytes(const store::RequestContext& context, const std::string& job_id,
                                   const std::string& name) override;
  Result<std::string> result_path(const store::RequestContext& context, const std::string& job_id,
                                  const std::string& name) override;
  Status share_results(const store::RequestContext& context, const std::string& from,
                       const std::string& to) override;
  Status remove_results(const store::RequestContext& context, const std::string& job_id) override;

  Status put_checkpoint(const store::RequestContext& context, const std::string& job_id,
                        std::string_view bytes) override;
  Result<KeptCheckpoint> checkpoint(const store::RequestContext& context, const std::string& job_id) override;
  Status remove_checkpoint(const store::RequestContext& context, const std::string& job_id) override;

  Result<std::optional<std::string>> get_setting(const store::RequestContext& context,
                                                 const std::string& key) override;
  Status put_setting(const store::RequestContext& context, const std::string& key,
                     const std::string& value) override;
  std::string scratch_folder() const override { return blobs_.scratch_folder().string(); }
  std::string log_folder() const override { return blobs_.log_folder().string(); }
  Result<std::string> job_log(const store::RequestContext& context, const std::string& job_id) override;
  store::StoreFigures figures() const override;
  Status ping() override;
  store::Accounts* accounts() override { return &accounts_; }
  store::Links* links() override { return &links_; }

  Result<std::vector<store::EventRow>> events_after(const store::OwnerId& owner, std::int64_t number,
                                                    int limit) override;
  Result<std::int64_t> newest_event(const store::OwnerId& owner) override;

  Result<store::WebhookRow> add_webhook(store::WebhookRow row) override;
  Result<std::vector<store::WebhookRow>> webhooks(const store::OwnerId& owner) override;
  Status remove_webhook(const store::OwnerId& owner, const std::string& id) override;
  Status ping_webhook(const store::OwnerId& owner, const std::string& id) override;
  Result<std::vector<store::DeliveryRow>> deliveries(const store::OwnerId& owner, const std::string& id,
                                                     int limit) override;
  Result<std::vector<store::DueDelivery>> due_deliveries(std::int64_t now_ms) override;
  Status change_delivery(const store::DeliveryRow& row) override;

  Result<std::vector<store::JobRow>> find_jobs(const store::RequestContext& context,
                                               const store::JobQuery& query, const std::string& cursor,
                                               int limit) override;
  Status set_tags(const store::RequestContext& context, const std::string& job,
                  const store::Tags& tags) override;
  Result<std::map<std::string, store::Tags>> tags_of_jobs(const store::OwnerId& owner,
                                                          const std::string& first,
                                                          const std::string& last) override;

  Result<store::Made<store::SweptJobs>> create_sweep(const store::RequestContext& context,
                                                     store::SweptJobs wanted,
                                                     const std::string& idempotency_key) override;
  Result<store::SweptJobs> sweep_of_key(const store::RequestContext& context,
                                        const std::string& idempotency_key) override;
  Result<store::SweepRow> sweep(const store::RequestContext& context, const std::string& id) override;
  Result<std::vector<store::SweepRow>> sweeps(const store::RequestContext& context,
                                              const std::string& project_id, const std::string& cursor,
                                              int limit) override;
  Result<std::vector<store::JobRow>> jobs_of_sweep(const store::RequestContext& context,
                                                   const std::string& id) override;

  Result<store::VersionRow> add_version(const store::RequestContext& context, store::VersionRow row,
                                        int expected) override;
  Result<store::VersionRow> version(const store::RequestContext& context, const std::string& project_id,
                                    const std::string& id) override;
  Result<std::vector<store::ToldVersion>> versions(const store::RequestContext& context,
                                                   const std::string& project_id) override;
  Status remove_version(const store::RequestContext& context, const std::string& project_id,
                        const std::string& id) override;

 private:
  // What follows expects mutex_ to be held.
  Result<bool> names_asset(const store::OwnerId& owner, const std::string& id);
  Result<store::ProjectRow> find_project(const store::OwnerId& owner, const std::string& id);
  Status insert_job(const store::OwnerId& owner, const store::JobRow& row,
                    const std::string& idempotency_key);
  Result<std::optional<store::ProjectRow>> project_of_key(const store::OwnerId& owner, const std::string& key,
                                                          const std::string& request);
  Status insert_project(const store::OwnerId& owner, const store::ProjectRow& row);
  Result<store::ProjectRow> update_project(const store::OwnerId& owner, const store::ProjectRow& now,
                                           const store::ProjectRow& row);
  Status append_edit(const store::OwnerId& owner, const std::string& project_id, const store::EditRow& edit);
  Status turn_edit(const store::OwnerId& owner, const std::string& project_id, std::int64_t number,
                   bool undone);
  Status trim_edits(const store::OwnerId& owner, const std::string& project_id);
  Status forget_edits(const store::OwnerId& owner, const std::string& project_id);
  Result<std::optional<store::JobRow>> find_job_of_key(const store::OwnerId& owner, const std::string& key);
  Result<std::optional<store::JobRow>> find_job_made(const store::OwnerId& owner,
                                                     const std::string& project_id, const std::string& key);
  Status write_job(const store::OwnerId& owner, const store::JobRow& row);
  Result<std::vector<OwnedJob>> find_unfinished_jobs();

  Result<store::Usage> usage_of(const store::OwnerId& owner);
  /// Error: quota.bytes when `more` bytes would be too many.
  Status check_room(const store::OwnerId& owner, std::size_t more);
  /// The same, and so many more jobs: quota.jobs.
  Status check_room_for_jobs(const store::OwnerId& owner, int jobs, std::size_t more);
  Status insert_tags(const store::OwnerId& owner, const std::string& job, const store::Tags& tags);
  Result<store::SweptJobs> find_sweep_of_key(const store::OwnerId& owner, const std::string& key);
  Result<std::vector<store::JobRow>> find_jobs_of_sweep(const store::OwnerId& owner, const std::string& id);
  Result<std::vector<std::string>> files_columns(const char* table);

  // And what follows takes it.
  Result<BlobPlace> blob_place(const store::OwnerId& owner, const std::string& id);
  Status check_job(const store::OwnerId& owner, const std::string& id);
  /// Gives a file of a job its name, while the lease of `context` is the job's.
  Status name_file(const store::RequestContext& context, const std::string& id,
                   const store::Blobs::Naming& naming);
  Result<store::ResultFile> kept_result(const store::OwnerId& owner, const std::string& job_id,
                                        const std::string& name);

  const Locks locks_;
  const std::shared_ptr<const store::Failures> failures_;
  const store::Quotas quotas_;
  const store::Blobs blobs_;
  /// Shared while bytes are put and named, held alone while a blob goes; before mutex_.
  std::shared_mutex blob_mutex_;
  std::mutex mutex_;  // guards what stands below; files are read and written without it
  SqlDatabase database_;
  GroupCommit commits_{mutex_, database_};
  store::IdSource ids_;
  SqliteAccounts accounts_{mutex_, database_, ids_};
  SqliteLinks links_{mutex_, database_, ids_};
};

/// That the project stands at the revision that somebody has seen; 0 stands for any. Error: store.conflict.
Status check_revision(const store::ProjectRow& now, int expected);
/// One more than any id when the cursor is empty, so that "before the cursor" is everything. Error:
/// store.cursor.
Result<std::string> before_what(const std::string& cursor, char letter);
/// Error: store.idempotency_key.
Status check_key(const std::string& key);
/// How many rows a page may have, of those asked for.
std::int64_t page_limit(int limit);

}  // namespace toile::sqlite
