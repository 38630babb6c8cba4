// The store on one machine: a SQLite database and folders of files.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <utility>

#include "core/base/hash.h"
#include "proto/cpp/names.h"
#include "server/store/blobs.h"
#include "server/store/file_name.h"
#include "server/store/folder_lock.h"
#include "server/store/ids.h"
#include "server/store/migrations.h"
#include "server/store/read_rows.h"
#include "server/store/rows.h"
#include "server/store/sqlite.h"
#include "server/store/store.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

constexpr int kLongestPage = 1000;
constexpr std::size_t kLongestKey = 200;  // bytes of an idempotency key

std::int64_t now_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

Result<std::string> text_from(const SqlStatement& row) { return row.text(0); }

Result<Store::OwnedJob> owned_job_from(const SqlStatement& row) {
  Result<JobRow> job = job_from(row);
  if (!job) return job.error();
  return Store::OwnedJob{row.text(kJobColumnCount), std::move(*job)};
}

std::string select(const char* columns, const char* rest) {
  return std::string("SELECT ") + columns + " " + rest;
}

/// One more than any id when the cursor is empty, so that "before the cursor" is everything.
Result<std::string> before_what(const std::string& cursor, char letter) {
  if (cursor.empty()) return std::string(1, letter) + "~";
  if (is_id(cursor, letter)) return cursor;
  return Error{"store.cursor", "the cursor " + in_quotes(cursor) + " is not one that a list gave", ""};
}

Status check_key(const std::string& key) {
  const bool printable = std::all_of(key.begin(), key.end(), [](char c) { return c > 0x20 && c < 0x7f; });
  if (printable && key.size() <= kLongestKey) return {};
  return Error{"store.idempotency_key", "an idempotency key has at most 200 printable ASCII characters", ""};
}

/// Where an asset's bytes lie: its blob and size.
struct BlobPlace {
  std::string blob;
  std::int64_t size = 0;
};

Result<BlobPlace> blob_place_from(const SqlStatement& row) { return BlobPlace{row.text(0), row.integer(1)}; }

class SqliteStore final : public Store {
 public:
  SqliteStore(FolderLock lock, Blobs blobs, SqlDatabase database, IdSource ids)
      : lock_(std::move(lock)), blobs_(std::move(blobs)), database_(std::move(database)), ids_(ids) {}

  Result<AssetRow> put_asset(const OwnerId& owner, AssetRow row, std::string_view bytes) override;
  Result<AssetRow> asset(const OwnerId& owner, const std::string& id) override;
  Result<std::string> asset_bytes(const OwnerId& owner, const std::string& id) override;
  Result<std::string> asset_path(const OwnerId& owner, const std::string& id) override;
  Result<std::vector<AssetRow>> assets(const OwnerId& owner, const std::string& kind) override;

  Result<ProjectRow> create_project(const OwnerId& owner, ProjectRow row) override;
  Result<ProjectRow> replace_project(const OwnerId& owner, const ProjectRow& row, int expected) override;
  Result<ProjectRow> project(const OwnerId& owner, const std::string& id) override;
  Result<std::vector<ProjectRow>> projects(const OwnerId& owner, const std::string& cursor,
                                           int limit) override;
  Status remove_project(const OwnerId& owner, const std::string& id) override;

  Result<JobRow> create_job(const OwnerId& owner, JobRow row, const std::string& idempotency_key) override;
  Result<JobRow> job(const OwnerId& owner, const std::string& id) override;
  Result<std::vector<JobRow>> jobs(const OwnerId& owner, const std::string& cursor, int limit) override;
  Status update_job(const OwnerId& owner, const JobRow& row) override;
  Result<std::vector<OwnedJob>> unfinished_jobs() override;

  Status put_result(const OwnerId& owner, const std::string& job_id, const std::string& name,
                    std::string_view bytes) override;
  Result<std::string> result_bytes(const OwnerId& owner, const std::string& job_id,
                                   const std::string& name) override;

  Result<std::optional<std::string>> get_setting(const OwnerId& owner, const std::string& key) override;
  Status put_setting(const OwnerId& owner, const std::string& key, const std::string& value) override;
  std::string scratch_folder() const override { return blobs_.scratch_folder().string(); }
  Status ping() override;

 private:
  // What follows expects mutex_ to be held.
  Result<ProjectRow> find_project(const OwnerId& owner, const std::string& id);
  Status insert_job(const OwnerId& owner, const JobRow& row, const std::string& idempotency_key);
  /// The job that this owner made with the key, if any.
  Result<std::optional<JobRow>> job_of_key(const OwnerId& owner, const JobRow& row, const std::string& key);

  // And what follows takes it.
  Result<BlobPlace> blob_place(const OwnerId& owner, const std::string& id);
  Status check_job(const OwnerId& owner, const std::string& id);

  const FolderLock lock_;
  const Blobs blobs_;
  std::mutex mutex_;  // guards what stands below; files are read and written without it
  SqlDatabase database_;
  IdSource ids_;
};

// Assets

Result<AssetRow> SqliteStore::put_asset(const OwnerId& owner, AssetRow row, std::string_view bytes) {
  if (Status good = check_name(row.name); !good) return good.error();
  row.id = "a_" + hash_of(row.kind + '/' + row.name + '/' + hash_of(bytes));  // no kind, no name has a slash
  row.size = static_cast<std::int64_t>(bytes.size());
  row.created_ms = now_ms();
  const Result<std::string> blob = blobs_.put_blob(bytes, row.name);
  if (!blob) return blob.error();
  const std::lock_guard hold(mutex_);
  const Result<int> kept = database_.run(
      "INSERT INTO assets (owner, id, kind, name, size, blob, created_ms, info) VALUES (?, ?, ?, ?, ?, ?, ?, "
      "?)"
      " ON CONFLICT DO NOTHING",
      {owner, row.id, row.kind, row.name, row.size, *blob, row.created_ms, row.info});
  if (!kept) return kept.error();
  return row_of(
      database_.prepare(select(kAssetColumns, "FROM assets WHERE owner = ? AND id = ?"), {owner, row.id}),
      asset_from, "asset", row.id);
}

Result<AssetRow> SqliteStore::asset(const OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return row_of(
      database_.prepare(select(kAssetColumns, "FROM assets WHERE owner = ? AND id = ?"), {owner, id}),
      asset_from, "asset", id);
}

Result<BlobPlace> SqliteStore::blob_place(const OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return row_of(database_.prepare("SELECT blob, size FROM assets WHERE owner = ? AND id = ?", {owner, id}),
                blob_place_from, "asset", id);
}

Result<std::string> SqliteStore::asset_bytes(const OwnerId& owner, const std::string& id) {
  const Result<BlobPlace> place = blob_place(owner, id);
  if (!place) return place.error();
  return blobs_.blob(place->blob, place->size);
}

Result<std::string> SqliteStore::asset_path(const OwnerId& owner, const std::string& id) {
  const Result<BlobPlace> place = blob_place(owner, id);
  if (!place) return place.error();
  const Result<fs::path> path = blobs_.blob_path(place->blob, place->size);
  if (!path) return path.error();
  return path->string();
}

Result<std::vector<AssetRow>> SqliteStore::assets(const OwnerId& owner, const std::string& kind) {
  const std::lock_guard hold(mutex_);
  return rows_of(database_.prepare(select(kAssetColumns,
                                          "FROM assets WHERE owner = ?1 AND (?2 = '' OR kind = ?2)"
                                          " ORDER BY created_ms DESC, rowid DESC"),
                                   {owner, kind}),
                 asset_from);
}

// Projects

Result<ProjectRow> SqliteStore::create_project(const OwnerId& owner, ProjectRow row) {
  const std::lock_guard hold(mutex_);
  row.created_ms = row.updated_ms = now_ms();
  row.revision = 1;
  Result<std::string> id = ids_.next('p', row.created_ms);
  if (!id) return id.error();
  row.id = std::move(*id);
  const std::string files = column_text(row.files);
  const Result<int> kept = database_.run(
      "INSERT INTO projects (owner, id, name, revision, document, files, created_ms, updated_ms)"
      " VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
      {owner, row.id, row.name, std::int64_t{row.revision}, row.document, files, row.created_ms,
       row.updated_ms});
  if (!kept) return kept.error();
  return row;
}

Result<ProjectRow> SqliteStore::replace_project(const OwnerId& owner, const ProjectRow& row, int expected) {
  const std::lock_guard hold(mutex_);
  Result<SqlTransaction> transaction = SqlTransaction::begin(database_);
  if (!transaction) return transaction.error();
  Result<ProjectRow> now = find_project(owner, row.id);
  if (!now) return now;
  if (expected != 0 && now->revision != expected) {
    return Error{"store.conflict",
                 "the project has been changed since: it is at revision " + std::to_string(now->revision) +
                     ", and this was made from revision " + std::to_string(expected),
                 ""};
  }
  now->name = row.name;
  now->document = row.document;
  now->files = row.files;
  now->revision += 1;
  now->updated_ms = now_ms();
  const std::string files = column_text(row.files);
  const Result<int> kept = database_.run(
      "UPDATE projects SET name = ?, document = ?, files = ?, revision = ?, updated_ms = ?"
      " WHERE owner = ? AND id = ?",
      {row.name, row.document, files, std::int64_t{now->revision}, now->updated_ms, owner, row.id});
  if (!kept) return kept.error();
  if (Status committed = transaction->commit(); !committed) return committed.error();
  return now;
}

Result<ProjectRow> SqliteStore::find_project(const OwnerId& owner, const std::string& id) {
  return row_of(
      database_.prepare(select(kProjectColumns, "FROM projects WHERE owner = ? AND id = ?"), {owner, id}),
      project_from, "project", id);
}

Result<ProjectRow> SqliteStore::project(const OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return find_project(owner, id);
}

Result<std::vector<ProjectRow>> SqliteStore::projects(const OwnerId& owner, const std::string& cursor,
                                                      int limit) {
  const Result<std::string> before = before_what(cursor, 'p');
  if (!before) return before.error();
  const std::lock_guard hold(mutex_);
  return rows_of(
      database_.prepare(
          select(kProjectColumns, "FROM projects WHERE owner = ? AND id < ? ORDER BY id DESC LIMIT ?"),
          {owner, *before, std::int64_t{std::clamp(limit, 0, kLongestPage)}}),
      project_from);
}

Status SqliteStore::remove_project(const OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  const Result<int> gone = database_.run("DELETE FROM projects WHERE owner = ? AND id = ?", {owner, id});
  if (!gone) return gone.error();
  if (*gone == 0) return not_found("project", id);
  return {};
}

// Jobs

Result<std::optional<JobRow>> SqliteStore::job_of_key(const OwnerId& owner, const JobRow& row,
                                                      const std::string& key) {
  Result<std::vector<JobRow>> made =
      rows_of(database_.prepare(select(kJobColumns, "FROM jobs WHERE owner = ? AND idempotency_key = ?"),
                                {owner, key}),
              job_from);
  if (!made) return made.error();
  if (made->empty()) return std::optional<JobRow>();
  JobRow& job = made->front();
  if (job.project_id == row.project_id && job.project_revision == row.project_revision) {
    return std::optional(std::move(job));
  }
  return Error{"store.idempotency_mismatch",
               "this idempotency key was used for revision " + std::to_string(job.project_revision) +
                   " of project " + job.project_id + "; use a new one for another drape",
               ""};
}

Status SqliteStore::insert_job(const OwnerId& owner, const JobRow& row, const std::string& idempotency_key) {
  const std::string files = column_text(row.files), results = column_text(row.results);
  const SqlValue key = idempotency_key.empty() ? SqlValue(nullptr) : SqlValue(idempotency_key);
  const Result<int> kept = database_.run(
      "INSERT INTO jobs (owner, id, project_id, project_revision, name, document, files, state, reason_code,"
      " reason, reason_where, attempt, created_ms, started_ms, ended_ms, report, results, idempotency_key)"
      " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      {owner, row.id, row.project_id, std::int64_t{row.project_revision}, row.name, row.document, files,
       row.state, row.reason_code, row.reason, row.reason_where, std::int64_t{row.attempt}, row.created_ms,
       row.started_ms, row.ended_ms, row.report, results, key});
  if (!kept) return kept.error();
  return {};
}

Result<JobRow> SqliteStore::create_job(const OwnerId& owner, JobRow row, const std::string& idempotency_key) {
  if (Status good = check_key(idempotency_key); !good) return good.error();
  const std::lock_guard hold(mutex_);
  Result<SqlTransaction> transaction = SqlTransaction::begin(database_);
  if (!transaction) return transaction.error();
  if (!idempotency_key.empty()) {
    Result<std::optional<JobRow>> made = job_of_key(owner, row, idempotency_key);
    if (!made) return made.error();
    if (*made) return std::move(**made);
  }
  row.created_ms = now_ms();
  Result<std::string> id = ids_.next('j', row.created_ms);
  if (!id) return id.error();
  row.id = std::move(*id);
  if (Status kept = insert_job(owner, row, idempotency_key); !kept) return kept.error();
  if (Status committed = transaction->commit(); !committed) return committed.error();
  return row;
}

Result<JobRow> SqliteStore::job(const OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return row_of(database_.prepare(select(kJobColumns, "FROM jobs WHERE owner = ? AND id = ?"), {owner, id}),
                job_from, "job", id);
}

Result<std::vector<JobRow>> SqliteStore::jobs(const OwnerId& owner, const std::string& cursor, int limit) {
  const Result<std::string> before = before_what(cursor, 'j');
  if (!before) return before.error();
  const std::lock_guard hold(mutex_);
  return rows_of(database_.prepare(
                     select(kJobListColumns, "FROM jobs WHERE owner = ? AND id < ? ORDER BY id DESC LIMIT ?"),
                     {owner, *before, std::int64_t{std::clamp(limit, 0, kLongestPage)}}),
                 job_from);
}

Status SqliteStore::update_job(const OwnerId& owner, const JobRow& row) {
  const std::string results = column_text(row.results);
  const std::lock_guard hold(mutex_);
  const Result<int> changed = database_.run(
      "UPDATE jobs SET state = ?, reason_code = ?, reason = ?, reason_where = ?, attempt = ?, started_ms = ?,"
      " ended_ms = ?, report = ?, results = ? WHERE owner = ? AND id = ?",
      {row.state, row.reason_code, row.reason, row.reason_where, std::int64_t{row.attempt}, row.started_ms,
       row.ended_ms, row.report, results, owner, row.id});
  if (!changed) return changed.error();
  if (*changed == 0) return not_found("job", row.id);
  return {};
}

Result<std::vector<Store::OwnedJob>> SqliteStore::unfinished_jobs() {
  const std::lock_guard hold(mutex_);
  return rows_of(
      database_.prepare(std::string("SELECT ") + kJobColumns +
                        ", owner FROM jobs WHERE state IN ('queued', 'running', 'paused') ORDER BY id"),
      owned_job_from);
}

// Results

Status SqliteStore::check_job(const OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  const Result<std::string> there = row_of(
      database_.prepare("SELECT id FROM jobs WHERE owner = ? AND id = ?", {owner, id}), text_from, "job", id);
  if (!there) return there.error();
  return {};
}

Status SqliteStore::put_result(const OwnerId& owner, const std::string& job_id, const std::string& name,
                               std::string_view bytes) {
  if (Status there = check_job(owner, job_id); !there) return there;
  return blobs_.put_result(job_id, name, bytes);
}

Result<std::string> SqliteStore::result_bytes(const OwnerId& owner, const std::string& job_id,
                                              const std::string& name) {
  if (Status there = check_job(owner, job_id); !there) return there.error();
  return blobs_.result(job_id, name);
}

// The rest

Result<std::optional<std::string>> SqliteStore::get_setting(const OwnerId& owner, const std::string& key) {
  const std::lock_guard hold(mutex_);
  Result<std::vector<std::string>> values = rows_of(
      database_.prepare("SELECT value FROM settings WHERE owner = ? AND key = ?", {owner, key}), text_from);
  if (!values) return values.error();
  if (values->empty()) return std::optional<std::string>();
  return std::optional(std::move(values->front()));
}

Status SqliteStore::put_setting(const OwnerId& owner, const std::string& key, const std::string& value) {
  const std::lock_guard hold(mutex_);
  const Result<int> kept = database_.run(
      "INSERT INTO settings (owner, key, value) VALUES (?, ?, ?)"
      " ON CONFLICT (owner, key) DO UPDATE SET value = excluded.value",
      {owner, key, value});
  if (!kept) return kept.error();
  return {};
}

Status SqliteStore::ping() {
  const std::lock_guard hold(mutex_);
  const Result<int> read = database_.run("SELECT number FROM schema_migrations LIMIT 1");
  if (!read) return read.error();
  return {};
}

/// An id source that goes on after the newest id that the database has.
Result<IdSource> ids_after(SqlDatabase& database) {
  IdSource ids;
  for (const char* newest : {"SELECT max(id) FROM projects", "SELECT max(id) FROM jobs"}) {
    const Result<std::string> id = row_of(database.prepare(newest), text_from, "id", "");
    if (!id) return id.error();
    ids.start_after(*id);
  }
  return ids;
}

/// The error of a part of the store as one of opening it. What a person must tell apart keeps its code.
Error opening(const fs::path& path, const Error& error) {
  const bool own_words = error.code == "store.newer_schema" || error.code == "store.in_use";
  return {own_words ? error.code : "store.open", error.message, path.string()};
}

}  // namespace

Result<std::unique_ptr<Store>> open_sqlite_store(const std::string& folder) {
  std::error_code failure;
  const fs::path root = fs::absolute(folder, failure);
  if (fs::create_directories(root, failure)) fs::permissions(root, fs::perms::owner_all, failure);
  if (!fs::is_directory(root)) {
    return Error{"store.open", "cannot make the folder: " + failure.message(), root.string()};
  }
  Result<FolderLock> lock = FolderLock::take(root);
  if (!lock) return lock.error();
  Result<Blobs> blobs = Blobs::open(root);
  if (!blobs) return opening(root, blobs.error());
  const fs::path file = root / "toile.db";
  Result<SqlDatabase> database = SqlDatabase::open(file.string());
  if (!database) return opening(file, database.error());
  if (Status migrated = migrate(*database); !migrated) return opening(file, migrated.error());
  const Result<IdSource> ids = ids_after(*database);
  if (!ids) return opening(file, ids.error());
  if (Status synced = sync_folder(root); !synced) return opening(root, synced.error());
  return std::unique_ptr<Store>(
      std::make_unique<SqliteStore>(std::move(*lock), std::move(*blobs), std::move(*database), *ids));
}

}  // namespace toile
