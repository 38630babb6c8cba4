// Sweeps: what their cells are called, and the jobs that stand in them.

#include "server/store/sweeps.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "server/store/now.h"
#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {

/// REQUIRES mutex_.
Result<std::vector<store::JobRow>> SqliteStore::find_jobs_of_sweep(const store::OwnerId& owner,
                                                                   const std::string& id) {
  return rows_of(
      database_.prepare(
          select(kJobListColumns, "FROM jobs WHERE owner = ? AND sweep = ? AND sweep <> '' ORDER BY id"),
          {owner, id}),
      job_from);
}

/// REQUIRES mutex_.
Result<store::SweptJobs> SqliteStore::find_sweep_of_key(const store::OwnerId& owner, const std::string& key) {
  if (key.empty()) return store::SweptJobs{};
  std::vector<store::SweepRow> made = TRY(
      rows_of(database_.prepare(select(kSweepColumns, "FROM sweeps WHERE owner = ? AND idempotency_key = ?"),
                                {owner, key}),
              sweep_from));
  if (made.empty()) return store::SweptJobs{};
  std::vector<store::JobRow> jobs = TRY(find_jobs_of_sweep(owner, made.front().id));
  return store::SweptJobs{std::move(made.front()), std::move(jobs)};
}

Result<store::SweptJobs> SqliteStore::sweep_of_key(const store::RequestContext& context,
                                                   const std::string& idempotency_key) {
  TRY(check_key(idempotency_key));
  const std::lock_guard hold(mutex_);
  return find_sweep_of_key(context.owner, idempotency_key);
}

Result<store::Made<store::SweptJobs>> SqliteStore::create_sweep(const store::RequestContext& context,
                                                                store::SweptJobs wanted,
                                                                const std::string& idempotency_key) {
  TRY(check_key(idempotency_key));
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  store::SweptJobs made = TRY(find_sweep_of_key(context.owner, idempotency_key));
  store::SweepRow& sweep = wanted.sweep;
  if (!made.sweep.id.empty()) {
    if (made.sweep.project_id == sweep.project_id)
      return store::Made<store::SweptJobs>{std::move(made), false};
    return Error{"store.idempotency_mismatch",
                 "this idempotency key was used for a sweep of project " + made.sweep.project_id +
                     "; use a new one for another sweep",
                 "", ErrorKind::kConflict};
  }
  std::size_t bytes = 0;
  for (const store::JobRow& job : wanted.jobs) bytes += job.document.size();
  TRY(check_room_for_jobs(context.owner, static_cast<int>(wanted.jobs.size()), bytes));
  sweep.created_ms = store::now_ms();
  sweep.id = TRY(ids_.next('s', sweep.created_ms));
  const SqlValue key = idempotency_key.empty() ? SqlValue(nullptr) : SqlValue(idempotency_key);
  TRY(database_.run(
      "INSERT INTO sweeps (owner, id, project_id, project_revision, name, created_ms,"
      " idempotency_key, bodies, fabrics) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
      {context.owner, sweep.id, sweep.project_id, std::int64_t{sweep.project_revision}, sweep.name,
       sweep.created_ms, key, column_text(sweep.bodies), column_text(sweep.fabrics)}));
  for (store::JobRow& job : wanted.jobs) {
    job.created_ms = sweep.created_ms;
    job.id = TRY(ids_.next('j', job.created_ms));
    job.cell.sweep = sweep.id;
    TRY(insert_job(context.owner, job, ""));
  }
  TRY(transaction.commit());
  return store::Made<store::SweptJobs>{std::move(wanted), true};
}

Result<store::SweepRow> SqliteStore::sweep(const store::RequestContext& context, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return row_of(
      database_.prepare(select(kSweepColumns, "FROM sweeps WHERE owner = ? AND id = ?"), {context.owner, id}),
      sweep_from, "sweep", id);
}

Result<std::vector<store::SweepRow>> SqliteStore::sweeps(const store::RequestContext& context,
                                                         const std::string& project_id,
                                                         const std::string& cursor, int limit) {
  const std::string before = TRY(before_what(cursor, 's'));
  const std::lock_guard hold(mutex_);
  return readable_rows_of(
      database_.prepare(select(kSweepColumns,
                               "FROM sweeps WHERE owner = ? AND id < ? AND (? = '' OR project_id = ?)"
                               " ORDER BY id DESC LIMIT ?"),
                        {context.owner, before, project_id, project_id, page_limit(limit)}),
      sweep_from, context.log);
}

Result<std::vector<store::JobRow>> SqliteStore::jobs_of_sweep(const store::RequestContext& context,
                                                              const std::string& id) {
  const std::lock_guard hold(mutex_);
  TRY(row_of(database_.prepare("SELECT id FROM sweeps WHERE owner = ? AND id = ?", {context.owner, id}),
             text_from, "sweep", id));
  return find_jobs_of_sweep(context.owner, id);
}

}  // namespace toile::sqlite
