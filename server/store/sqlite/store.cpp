// Opening the store; assets, projects and settings.

#include "server/store/sqlite/store.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>

#include "core/base/hash.h"
#include "core/base/names.h"
#include "server/store/file_name.h"
#include "server/store/now.h"
#include "server/store/sqlite/migrations.h"
#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/rows.h"
#include "server/store/sqlite/sweep.h"

namespace toile::sqlite {
namespace {

namespace fs = std::filesystem;

/// What an idempotency key made: a project's id, and the hash of the request.
struct KeyedProject {
  std::string id, request;
};

Result<KeyedProject> keyed_project_from(const SqlStatement& row) {
  return KeyedProject{row.text(0), row.text(1)};
}

Result<BlobPlace> blob_place_from(const SqlStatement& row) { return BlobPlace{row.text(0), row.integer(1)}; }

}  // namespace

Status check_revision(const store::ProjectRow& now, int expected) {
  if (expected == 0 || now.revision == expected) return {};
  return Error{"store.conflict",
               "the project has been changed since: it is at revision " + std::to_string(now.revision) +
                   ", and this was made from revision " + std::to_string(expected),
               "", ErrorKind::kStale};
}

Result<std::string> before_what(const std::string& cursor, char letter) {
  if (cursor.empty()) return std::string(1, letter) + "~";
  if (store::is_id(cursor, letter)) return cursor;
  return Error{"store.cursor", "the cursor " + in_quotes(cursor) + " is not one that a list gave", "",
               ErrorKind::kMalformed};
}

Status check_key(const std::string& key) {
  constexpr std::size_t kLongestKey = 200;
  const bool printable = std::all_of(key.begin(), key.end(), [](char c) { return c > 0x20 && c < 0x7f; });
  if (printable && key.size() <= kLongestKey) return {};
  return Error{"store.idempotency_key", "an idempotency key has at most 200 printable ASCII characters", "",
               ErrorKind::kMalformed};
}

std::int64_t page_limit(int limit) {
  constexpr int kLongestPage = 1000;
  return std::clamp(limit, 0, kLongestPage);
}

// Assets

Result<store::AssetRow> SqliteStore::put_asset(const store::RequestContext& context, store::AssetRow row,
                                               std::string_view bytes) {
  TRY(store::check_name(row.name));
  row.id = store::asset_id(row.kind, row.name, bytes);
  row.size = static_cast<std::int64_t>(bytes.size());
  row.created_ms = store::now_ms();
  if (const Result<store::AssetRow> there = asset(context, row.id); !there) {
    const std::lock_guard hold(mutex_);
    TRY(check_room(context.owner, bytes.size()));
  }
  const std::shared_lock putting(blob_mutex_);
  const std::string blob = TRY(blobs_.put_blob(bytes, row.name));
  const std::lock_guard hold(mutex_);
  TRY(database_.run(
      "INSERT INTO assets (owner, id, kind, name, size, blob, created_ms, info) VALUES (?, ?, ?, ?, ?, ?, ?, "
      "?)"
      " ON CONFLICT DO NOTHING",
      {context.owner, row.id, row.kind, row.name, row.size, blob, row.created_ms, row.info}));
  return row_of(database_.prepare(select(kAssetColumns, "FROM assets WHERE owner = ? AND id = ?"),
                                  {context.owner, row.id}),
                asset_from, "asset", row.id);
}

Result<store::AssetRow> SqliteStore::asset(const store::RequestContext& context, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return row_of(
      database_.prepare(select(kAssetColumns, "FROM assets WHERE owner = ? AND id = ?"), {context.owner, id}),
      asset_from, "asset", id);
}

Result<BlobPlace> SqliteStore::blob_place(const store::OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return row_of(database_.prepare("SELECT blob, size FROM assets WHERE owner = ? AND id = ?", {owner, id}),
                blob_place_from, "asset", id);
}

Result<std::string> SqliteStore::asset_bytes(const store::RequestContext& context, const std::string& id) {
  const BlobPlace place = TRY(blob_place(context.owner, id));
  return blobs_.blob(place.blob, place.size);
}

Result<std::string> SqliteStore::asset_path(const store::RequestContext& context, const std::string& id) {
  const BlobPlace place = TRY(blob_place(context.owner, id));
  const fs::path path = TRY(blobs_.blob_path(place.blob, place.size));
  return path.string();
}

Result<std::vector<store::AssetRow>> SqliteStore::assets(const store::RequestContext& context,
                                                         const std::string& kind) {
  const std::lock_guard hold(mutex_);
  return rows_of(database_.prepare(select(kAssetColumns,
                                          "FROM assets WHERE owner = ?1 AND (?2 = '' OR kind = ?2)"
                                          " ORDER BY created_ms DESC, rowid DESC"),
                                   {context.owner, kind}),
                 asset_from);
}

/// Whether a project or a job has the asset among its files, as column_text writes them: `"name": "id"`.
Result<bool> SqliteStore::names_asset(const store::OwnerId& owner, const std::string& id) {
  const std::string quoted = '"' + id + '"';
  for (const char* sql : {"SELECT count(*) FROM projects WHERE owner = ? AND instr(files, ?) > 0",
                          "SELECT count(*) FROM jobs WHERE owner = ? AND instr(files, ?) > 0",
                          "SELECT count(*) FROM versions WHERE owner = ? AND instr(files, ?) > 0"}) {
    SqlStatement count = TRY(database_.prepare(sql, {owner, quoted}));
    TRY(count.step());
    if (count.integer(0) > 0) return true;
  }
  return false;
}

Status SqliteStore::remove_asset(const store::RequestContext& context, const std::string& id) {
  const std::unique_lock alone(blob_mutex_);
  const BlobPlace place = TRY(blob_place(context.owner, id));
  const std::lock_guard hold(mutex_);
  const bool named = TRY(names_asset(context.owner, id));
  if (named) {
    return Error{"store.in_use", "a project, a version of one or a job uses this file; remove that first", "",
                 ErrorKind::kConflict};
  }
  TRY(database_.run("DELETE FROM assets WHERE owner = ? AND id = ?", {context.owner, id}));
  SqlStatement others = TRY(database_.prepare("SELECT count(*) FROM assets WHERE blob = ?", {place.blob}));
  TRY(others.step());
  if (others.integer(0) == 0) blobs_.remove_blob(place.blob);
  return {};
}

// Projects

/// The project that was made with the key, when `request` is what it was made of.
Result<std::optional<store::ProjectRow>> SqliteStore::project_of_key(const store::OwnerId& owner,
                                                                     const std::string& key,
                                                                     const std::string& request) {
  const std::vector<KeyedProject> made = TRY(
      rows_of(database_.prepare("SELECT project_id, request FROM project_keys WHERE owner = ? AND key = ?",
                                {owner, key}),
              keyed_project_from));
  if (made.empty()) return std::optional<store::ProjectRow>();
  if (made.front().request != request) {
    return Error{"store.idempotency_mismatch",
                 "this idempotency key was used for another document or other files, for project " +
                     made.front().id + "; use a new one for another project",
                 "", ErrorKind::kConflict};
  }
  store::ProjectRow project = TRY(find_project(owner, made.front().id));
  return std::optional(std::move(project));
}

Status SqliteStore::insert_project(const store::OwnerId& owner, const store::ProjectRow& row) {
  const std::string files = column_text(row.files);
  TRY(
      database_.run("INSERT INTO projects (owner, id, name, revision, document, files, created_ms, "
                    "updated_ms, document_bytes)"
                    " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
                    {owner, row.id, row.name, std::int64_t{row.revision}, row.document, files, row.created_ms,
                     row.updated_ms, static_cast<std::int64_t>(row.document.size())}));
  return {};
}

Result<store::Made<store::ProjectRow>> SqliteStore::create_project(const store::RequestContext& context,
                                                                   store::ProjectRow row,
                                                                   const std::string& idempotency_key) {
  TRY(check_key(idempotency_key));
  const std::string request = hash_of(row.document + '\n' + column_text(row.files));
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  if (!idempotency_key.empty()) {
    std::optional<store::ProjectRow> made = TRY(project_of_key(context.owner, idempotency_key, request));
    if (made) return store::Made<store::ProjectRow>{std::move(*made), false};
  }
  TRY(check_room(context.owner, row.document.size()));
  row.created_ms = row.updated_ms = store::now_ms();
  row.revision = 1;
  std::string id = TRY(ids_.next('p', row.created_ms));
  row.id = std::move(id);
  TRY(insert_project(context.owner, row));
  if (!idempotency_key.empty()) {
    TRY(database_.run("INSERT INTO project_keys (owner, key, project_id, request) VALUES (?, ?, ?, ?)",
                      {context.owner, idempotency_key, row.id, request}));
  }
  TRY(transaction.commit());
  return store::Made<store::ProjectRow>{std::move(row), true};
}

Result<store::ProjectRow> SqliteStore::replace_project(const store::RequestContext& context,
                                                       const store::ProjectRow& row, int expected) {
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  const store::ProjectRow now = TRY(find_project(context.owner, row.id));
  TRY(check_revision(now, expected));
  const store::ProjectRow kept = TRY(update_project(context.owner, now, row));
  TRY(forget_edits(context.owner, row.id));
  TRY(transaction.commit());
  return kept;
}

/// `now` with name, document and files of `row`, one revision on.
Result<store::ProjectRow> SqliteStore::update_project(const store::OwnerId& owner,
                                                      const store::ProjectRow& now,
                                                      const store::ProjectRow& row) {
  store::ProjectRow next = now;
  next.name = row.name;
  next.document = row.document;
  next.files = row.files;
  next.revision += 1;
  next.updated_ms = store::now_ms();
  const std::string files = column_text(row.files);
  TRY(
      database_.run("UPDATE projects SET name = ?, document = ?, files = ?, revision = ?, updated_ms = ?,"
                    " document_bytes = ?"
                    " WHERE owner = ? AND id = ?",
                    {next.name, next.document, files, std::int64_t{next.revision}, next.updated_ms,
                     static_cast<std::int64_t>(next.document.size()), owner, next.id}));
  return next;
}

Result<store::ProjectRow> SqliteStore::find_project(const store::OwnerId& owner, const std::string& id) {
  return row_of(
      database_.prepare(select(kProjectColumns, "FROM projects WHERE owner = ? AND id = ?"), {owner, id}),
      project_from, "project", id);
}

Result<store::ProjectRow> SqliteStore::project(const store::RequestContext& context, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return find_project(context.owner, id);
}

Result<std::vector<store::ProjectRow>> SqliteStore::projects(const store::RequestContext& context,
                                                             const std::string& cursor, int limit) {
  const std::string before = TRY(before_what(cursor, 'p'));
  const std::lock_guard hold(mutex_);
  return readable_rows_of(
      database_.prepare(
          select(kProjectColumns, "FROM projects WHERE owner = ? AND id < ? ORDER BY id DESC LIMIT ?"),
          {context.owner, before, page_limit(limit)}),
      project_from, context.log);
}

Status SqliteStore::remove_project(const store::RequestContext& context, const std::string& id,
                                   int expected) {
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  const store::ProjectRow now = TRY(find_project(context.owner, id));
  TRY(check_revision(now, expected));
  for (const char* sql : {"DELETE FROM projects WHERE owner = ? AND id = ?",
                          "DELETE FROM project_keys WHERE owner = ? AND project_id = ?"}) {
    TRY(database_.run(sql, {context.owner, id}));
  }
  TRY(forget_edits(context.owner, id));
  return transaction.commit();
}

// The rest

Result<std::optional<std::string>> SqliteStore::get_setting(const store::RequestContext& context,
                                                            const std::string& key) {
  const std::lock_guard hold(mutex_);
  std::vector<std::string> values = TRY(rows_of(
      database_.prepare("SELECT value FROM settings WHERE owner = ? AND key = ?", {context.owner, key}),
      text_from));
  if (values.empty()) return std::optional<std::string>();
  return std::optional(std::move(values.front()));
}

Status SqliteStore::put_setting(const store::RequestContext& context, const std::string& key,
                                const std::string& value) {
  const std::lock_guard hold(mutex_);
  TRY(
      database_.run("INSERT INTO settings (owner, key, value) VALUES (?, ?, ?)"
                    " ON CONFLICT (owner, key) DO UPDATE SET value = excluded.value",
                    {context.owner, key, value}));
  return {};
}

Status SqliteStore::ping() {
  const std::lock_guard hold(mutex_);
  const std::string now = std::to_string(store::now_ms());
  TRY(
      database_.run("INSERT INTO settings (owner, key, value) VALUES ('', 'ping', ?)"
                    " ON CONFLICT (owner, key) DO UPDATE SET value = excluded.value",
                    {now}));
  const std::string read =
      TRY(row_of(database_.prepare("SELECT value FROM settings WHERE owner = '' AND key = 'ping'"), text_from,
                 "row", ""));
  if (read == now) return {};
  return Error{"store.failed", "the database does not give back what it was given", "", ErrorKind::kSystem};
}

}  // namespace toile::sqlite
