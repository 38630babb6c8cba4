// Jobs of the store, their results and checkpoints.

#include <cstdlib>
#include <filesystem>
#include <map>

#include "server/store/now.h"
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
  std::vector<store::JobRow> made =
      TRY(rows_of(database_.prepare(select(kJobColumns, "FROM jobs WHERE owner = ? AND idempotency_key = ?"),
                                    {owner, key}),
                  job_from));
  if (made.empty()) return std::optional<store::JobRow>();
  return std::optional(std::move(made.front()));
}

Result<std::optional<store::JobRow>> SqliteStore::job_of_key(const store::RequestContext& context,
                                                             const std::string& idempotency_key) {
  TRY(check_key(idempotency_key));
  if (idempotency_key.empty()) return std::optional<store::JobRow>();
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
      " document_bytes, priority, input, sweep, sweep_body, sweep_fabric, pictures) VALUES"
      " (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
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
       row.input,
       row.cell.sweep,
       std::int64_t{row.cell.body},
       std::int64_t{row.cell.fabric},
       std::int64_t{row.pictures}}));
  return insert_tags(owner, row.id, row.tags);
}

/// The job that was made with the key, of the same project.
Result<std::optional<store::JobRow>> SqliteStore::find_job_made(const store::OwnerId& owner,
                                                                const std::string& project_id,
                                                                const std::string& key) {
  std::optional<store::JobRow> made = TRY(find_job_of_key(owner, key));
  if (!made || made->project_id == project_id) return made;
  return Error{
      "store.idempotency_mismatch",
      "this idempotency key was used for project " + made->project_id + "; use a new one for another drape",
      "", ErrorKind::kConflict};
}

/// Together with what others submit at the same time: each by itself would wait for the disk.
Result<store::Made<store::JobRow>> SqliteStore::create_job(const store::RequestContext& context,
                                                           store::JobRow row,
                                                           const std::string& idempotency_key) {
  TRY(check_key(idempotency_key));
  std::optional<store::JobRow> made;
  const GroupCommit::Write make = [&]() -> Status {
    made = TRY(find_job_made(context.owner, row.project_id, idempotency_key));
    if (made) return {};
    TRY(check_room_for_jobs(context.owner, 1, row.document.size()));
    row.created_ms = store::now_ms();
    row.id = TRY(ids_.next('j', row.created_ms));
    return insert_job(context.owner, row, idempotency_key);
  };
  TRY(commits_.run(make));
  if (made) return store::Made<store::JobRow>{std::move(*made), false};
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

/// REQUIRES mutex_.
Status SqliteStore::write_job(const store::OwnerId& owner, const store::JobRow& row) {
  const std::string results = column_text(row.results), notes = column_text(row.notes),
                    verdict = column_text(row.verdict);
  const int changed = TRY(database_.run(
      "UPDATE jobs SET state = ?, reason_code = ?, reason = ?, reason_where = ?, attempt = ?, started_ms = ?,"
      " ended_ms = ?, report = ?, results = ?, notes = ?, verdict = ?,"
      " result_bytes = ?, worked_ms = ?, suspect = ?, holder = ?, lease = ?, lease_until_ms = ?, progress = "
      "?, input = ?"
      " WHERE owner = ? AND id = ?",
      {store::name_of(row.state),
       row.reason_code,
       row.reason,
       row.reason_where,
       std::int64_t{row.attempt},
       row.started_ms,
       row.ended_ms,
       row.report,
       results,
       notes,
       verdict,
       bytes_of(row.results),
       row.worked_ms,
       std::int64_t{row.suspect},
       row.lease.holder,
       row.lease.number,
       row.lease.until_ms,
       row.progress,
       row.input,
       owner,
       row.id}));
  if (changed == 0) return not_found("job", row.id);
  return {};
}

Result<store::JobRow> SqliteStore::change_job(const store::RequestContext& context, const std::string& id,
                                              const JobEdit& edit) {
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  store::JobRow row = TRY(row_of(
      database_.prepare(select(kJobListColumns, "FROM jobs WHERE owner = ? AND id = ?"), {context.owner, id}),
      job_from, "job", id));
  if (context.lease != 0 && context.lease != row.lease.number) return store::lease_lost();
  TRY(edit(row));
  TRY(write_job(context.owner, row));
  TRY(transaction.commit());
  return row;
}

/// REQUIRES mutex_.
Result<std::vector<store::Store::OwnedJob>> SqliteStore::find_unfinished_jobs() {
  return readable_rows_of(
      database_.prepare(std::string("SELECT ") + kJobListColumns + ", owner FROM jobs WHERE state IN (" +
                        store::unfinished_states_in_sql() + ") ORDER BY id"),
      owned_job_from, Log());
}

Result<std::vector<store::Store::OwnedJob>> SqliteStore::unfinished_jobs() {
  const std::lock_guard hold(mutex_);
  return find_unfinished_jobs();
}

Result<std::vector<store::Store::OwnedJob>> SqliteStore::take_from_the_gone(std::int64_t now_ms, bool own,
                                                                            const JudgeJob& judge) {
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  std::vector<OwnedJob> jobs = TRY(find_unfinished_jobs());
  std::map<std::string, int> running;  // by holder
  for (const OwnedJob& owned : jobs)
    running[owned.job.lease.holder] += owned.job.state == store::JobState::kRunning;
  std::erase_if(jobs, [&](const OwnedJob& owned) {
    const store::JobLease& lease = owned.job.lease;
    if (lease.holder.empty()) return owned.job.state != store::JobState::kRunning;
    if (own && lease.holder == locks_.holder.id()) return false;
    return lease.until_ms > now_ms && !locks_.holder.is_gone(lease.holder);
  });
  for (OwnedJob& owned : jobs) {
    const int with_it = running[owned.job.lease.holder];
    owned.job.lease.holder.clear();
    const std::int64_t kept_ms = blobs_.checkpoint_ms(owned.job.id);
    LeftJob left{std::move(owned), with_it, kept_ms};
    judge(left);
    owned = std::move(left.owned);
    TRY(write_job(owned.owner, owned.job));
  }
  TRY(transaction.commit());
  return jobs;
}

/// What SQLite counts up when another connection has committed.
std::int64_t SqliteStore::changes_by_others() {
  const std::lock_guard hold(mutex_);
  const Result<std::string> version =
      row_of(database_.prepare("PRAGMA data_version"), text_from, "version", "");
  return version ? std::atoll(version->c_str()) : -1;
}

/// A name once given is not taken back, so that whoever takes the job over must not come in between.
Status SqliteStore::name_file(const store::RequestContext& context, const std::string& id,
                              const store::Blobs::Naming& naming) {
  if (context.lease == 0) return naming();
  const std::lock_guard hold(mutex_);
  const SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  const store::JobRow row = TRY(row_of(
      database_.prepare(select(kJobListColumns, "FROM jobs WHERE owner = ? AND id = ?"), {context.owner, id}),
      job_from, "job", id));
  if (context.lease != row.lease.number || store::is_final(row.state)) return store::lease_lost();
  return naming();
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
  return blobs_.put_result(job_id, name, bytes, [&](const store::Blobs::Naming& naming) {
    return name_file(context, job_id, naming);
  });
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
  return blobs_.put_checkpoint(
      job_id, bytes, [&](const store::Blobs::Naming& naming) { return name_file(context, job_id, naming); });
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
