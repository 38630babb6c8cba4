// Jobs of the store, their results and checkpoints.

#include <filesystem>

#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

Result<store::Store::OwnedJob> owned_job_from(const SqlStatement& row) {
  store::JobRow job = TRY(job_from(row));
  return store::Store::OwnedJob{row.text(kJobColumnCount), std::move(job)};
}

std::int64_t bytes_of(const store::ResultFiles& results) {
  std::int64_t bytes = 0;
  for (const auto& [name, file] : results) bytes += file.bytes;
  return bytes;
}

}  // namespace

Result<std::optional<store::JobRow>> SqliteStore::find_job_of_key(const store::OwnerId& owner,
                                                                  const std::string& key) {
  if (key.empty()) return std::optional<store::JobRow>();
  Result<std::vector<store::JobRow>> made =
      rows_of(database_.prepare(select(kJobColumns, "FROM jobs WHERE owner = ? AND idempotency_key = ?"),
                                {owner, key}),
              job_from);
  if (!made) return made.error();
  if (made->empty()) return std::optional<store::JobRow>();
  return std::optional(std::move(made->front()));
}

Result<std::optional<store::JobRow>> SqliteStore::job_of_key(const store::RequestContext& context,
                                                             const std::string& idempotency_key) {
  TRY(check_key(idempotency_key));
  const std::lock_guard hold(mutex_);
  return find_job_of_key(context.owner, idempotency_key);
}

Status SqliteStore::insert_job(const store::OwnerId& owner, const store::JobRow& row,
                               const std::string& idempotency_key) {
  const std::string files = column_text(row.files), results = column_text(row.results);
  const SqlValue key = idempotency_key.empty() ? SqlValue(nullptr) : SqlValue(idempotency_key);
  TRY(database_.run(
      "INSERT INTO jobs (owner, id, project_id, project_revision, name, document, files, state, reason_code,"
      " reason, reason_where, attempt, created_ms, started_ms, ended_ms, report, results, idempotency_key,"
      " document_bytes, priority, input) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
      "?)",
      {owner,
       row.id,
       row.project_id,
       std::int64_t{row.project_revision},
       row.name,
       row.document,
       files,
       store::name_of(row.state),
       row.reason_code,
       row.reason,
       row.reason_where,
       std::int64_t{row.attempt},
       row.created_ms,
       row.started_ms,
       row.ended_ms,
       row.report,
       results,
       key,
       static_cast<std::int64_t>(row.document.size()),
       store::name_of(row.priority),
       row.input}));
  return {};
}

Result<store::Made<store::JobRow>> SqliteStore::create_job(const store::RequestContext& context,
                                                           store::JobRow row,
                                                           const std::string& idempotency_key) {
  TRY(check_key(idempotency_key));
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  std::optional<store::JobRow> made = TRY(find_job_of_key(context.owner, idempotency_key));
  if (made) {
    if (made->project_id == row.project_id) return store::Made<store::JobRow>{std::move(*made), false};
    return Error{
        "store.idempotency_mismatch",
        "this idempotency key was used for project " + made->project_id + "; use a new one for another drape",
        "", ErrorKind::kConflict};
  }
  TRY(check_room_for_job(context.owner, row.document.size()));
  row.created_ms = store_now_ms();
  std::string id = TRY(ids_.next('j', row.created_ms));
  row.id = std::move(id);
  TRY(insert_job(context.owner, row, idempotency_key));
  TRY(transaction.commit());
  return store::Made<store::JobRow>{std::move(row), true};
}

Result<store::JobRow> SqliteStore::job(const store::RequestContext& context, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return row_of(
      database_.prepare(select(kJobColumns, "FROM jobs WHERE owner = ? AND id = ?"), {context.owner, id}),
      job_from, "job", id);
}

Result<std::vector<store::JobRow>> SqliteStore::jobs(const store::RequestContext& context,
                                                     const std::string& cursor, int limit) {
  const std::string before = TRY(before_what(cursor, 'j'));
  const std::lock_guard hold(mutex_);
  return readable_rows_of(
      database_.prepare(
          select(kJobListColumns, "FROM jobs WHERE owner = ? AND id < ? ORDER BY id DESC LIMIT ?"),
          {context.owner, before, page_limit(limit)}),
      job_from, context.log);
}

Result<std::optional<store::JobRow>> SqliteStore::succeeded_job_of_input(const store::RequestContext& context,
                                                                         const std::string& input) {
  if (input.empty()) return std::optional<store::JobRow>();
  const std::lock_guard hold(mutex_);
  std::vector<store::JobRow> found =
      TRY(rows_of(database_.prepare(select(kJobColumns,
                                           "FROM jobs WHERE owner = ? AND input = ? AND input <> ''"
                                           " AND state = 'succeeded' ORDER BY id DESC LIMIT 1"),
                                    {context.owner, input}),
                  job_from));
  if (found.empty()) return std::optional<store::JobRow>();
  return std::optional(std::move(found.front()));
}

Result<std::vector<std::string>> SqliteStore::jobs_of_project(const store::RequestContext& context,
                                                              const std::string& project_id) {
  const std::lock_guard hold(mutex_);
  return rows_of(database_.prepare("SELECT id FROM jobs WHERE owner = ? AND project_id = ? ORDER BY id",
                                   {context.owner, project_id}),
                 text_from);
}

/// The row first: what is left of its files after a crash, the next start removes.
Status SqliteStore::remove_job(const store::RequestContext& context, const std::string& id) {
  {
    const std::lock_guard hold(mutex_);
    const std::string word = TRY(
        row_of(database_.prepare("SELECT state FROM jobs WHERE owner = ? AND id = ?", {context.owner, id}),
               text_from, "job", id));
    const Result<store::JobState> state = store::job_state_from(word);
    if (state && !store::is_final(*state)) {
      return Error{"store.in_use", "the job has not ended; cancel it first", "", ErrorKind::kConflict};
    }
    TRY(database_.run("DELETE FROM jobs WHERE owner = ? AND id = ?", {context.owner, id}));
  }
  blobs_.remove_log(id);
  TRY(blobs_.remove_checkpoint(id));
  return blobs_.remove_results(id);
}

Status SqliteStore::update_job(const store::RequestContext& context, const store::JobRow& row) {
  const std::string results = column_text(row.results), notes = column_text(row.notes),
                    verdict = column_text(row.verdict);
  const std::lock_guard hold(mutex_);
  const int changed = TRY(database_.run(
      "UPDATE jobs SET state = ?, reason_code = ?, reason = ?, reason_where = ?, attempt = ?, started_ms = ?,"
      " ended_ms = ?, report = ?, results = ?, notes = ?, verdict = ?,"
      " result_bytes = ?, worked_ms = ? WHERE owner = ? AND id = ?",
      {store::name_of(row.state), row.reason_code, row.reason, row.reason_where, std::int64_t{row.attempt},
       row.started_ms, row.ended_ms, row.report, results, notes, verdict, bytes_of(row.results),
       row.worked_ms, context.owner, row.id}));
  if (changed == 0) return not_found("job", row.id);
  return {};
}

Result<std::vector<store::Store::OwnedJob>> SqliteStore::unfinished_jobs() {
  const std::lock_guard hold(mutex_);
  return readable_rows_of(
      database_.prepare(std::string("SELECT ") + kJobColumns + ", owner FROM jobs WHERE state IN (" +
                        store::unfinished_states_in_sql() + ") ORDER BY id"),
      owned_job_from, Log());
}

// Results

/// As its row has it; one that no row names yet may be anything.
Result<store::ResultFile> SqliteStore::kept_result(const store::OwnerId& owner, const std::string& job_id,
                                                   const std::string& name) {
  const std::lock_guard hold(mutex_);
  const std::string column =
      TRY(row_of(database_.prepare("SELECT results FROM jobs WHERE owner = ? AND id = ?", {owner, job_id}),
                 text_from, "job", job_id));
  const store::ResultFiles results = TRY(results_from(column, job_id));
  const auto found = results.find(name);
  return found == results.end() ? store::ResultFile() : found->second;
}

Status SqliteStore::check_job(const store::OwnerId& owner, const std::string& id) {
  const std::lock_guard hold(mutex_);
  TRY(row_of(database_.prepare("SELECT id FROM jobs WHERE owner = ? AND id = ?", {owner, id}), text_from,
             "job", id));
  return {};
}

Status SqliteStore::put_result(const store::RequestContext& context, const std::string& job_id,
                               const std::string& name, std::string_view bytes) {
  TRY(check_job(context.owner, job_id));
  return blobs_.put_result(job_id, name, bytes);
}

Result<std::string> SqliteStore::result_bytes(const store::RequestContext& context, const std::string& job_id,
                                              const std::string& name) {
  const store::ResultFile kept = TRY(kept_result(context.owner, job_id, name));
  return blobs_.result(job_id, name, kept);
}

Result<std::string> SqliteStore::result_path(const store::RequestContext& context, const std::string& job_id,
                                             const std::string& name) {
  const store::ResultFile kept = TRY(kept_result(context.owner, job_id, name));
  if (!kept.hash.empty()) {
    TRY(blobs_.result(job_id, name, kept));
  }
  const std::filesystem::path path = TRY(blobs_.result_path(job_id, name));
  return path.string();
}

/// Each is read before: what the disk has changed is not handed on.
Status SqliteStore::share_results(const store::RequestContext& context, const std::string& from,
                                  const std::string& to) {
  TRY(check_job(context.owner, to));
  const store::JobRow row = TRY(job(context, from));
  for (const auto& [name, file] : row.results) {
    TRY(blobs_.result(from, name, file));
    TRY(blobs_.share_result(from, to, name));
  }
  return blobs_.sync_results(to);
}

Status SqliteStore::remove_results(const store::RequestContext& context, const std::string& job_id) {
  TRY(check_job(context.owner, job_id));
  return blobs_.remove_results(job_id);
}

// Checkpoints

Status SqliteStore::put_checkpoint(const store::RequestContext& context, const std::string& job_id,
                                   std::string_view bytes) {
  TRY(check_job(context.owner, job_id));
  return blobs_.put_checkpoint(job_id, bytes);
}

Result<store::Store::KeptCheckpoint> SqliteStore::checkpoint(const store::RequestContext& context,
                                                             const std::string& job_id) {
  TRY(check_job(context.owner, job_id));
  return blobs_.checkpoint(job_id);
}

Status SqliteStore::remove_checkpoint(const store::RequestContext& context, const std::string& job_id) {
  TRY(check_job(context.owner, job_id));
  return blobs_.remove_checkpoint(job_id);
}

}  // namespace toile::sqlite
