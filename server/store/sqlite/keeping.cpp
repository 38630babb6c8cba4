// What owners keep, what they may keep, and what has been kept long enough.

#include <set>
#include <system_error>

#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

Result<store::OwnedId> owned_id_from(const SqlStatement& row) {
  return store::OwnedId{row.text(0), row.text(1)};
}

Result<store::Usage> usage_from(const SqlStatement& row) {
  store::Usage usage;
  usage.bytes = row.integer(0) + row.integer(1) + row.integer(2) + row.integer(7);
  usage.assets = static_cast<int>(row.integer(3));
  usage.projects = static_cast<int>(row.integer(4));
  usage.jobs = static_cast<int>(row.integer(5));
  usage.unfinished_jobs = static_cast<int>(row.integer(6));
  return usage;
}

std::string megabytes(std::int64_t bytes) {
  constexpr std::int64_t kMegabyte = 1'000'000;
  return std::to_string((bytes + kMegabyte - 1) / kMegabyte) + " MB";
}

/// The ids that a `files` column names; a damaged one names what it seems to, so that too much is kept rather
/// than too little.
void add_ids(std::set<std::string>& ids, const std::string& column) {
  constexpr std::size_t kIdSize = 34;  // "a_" and 32 digits
  for (std::size_t at = column.find("a_"); at != std::string::npos; at = column.find("a_", at + 1))
    ids.insert(column.substr(at, kIdSize));
}

}  // namespace

Result<store::Usage> SqliteStore::usage_of(const store::OwnerId& owner) {
  return row_of(database_.prepare(
                    "SELECT (SELECT coalesce(sum(size), 0) FROM assets WHERE owner = ?1),"
                    " (SELECT coalesce(sum(document_bytes), 0) FROM projects WHERE owner = ?1),"
                    " (SELECT coalesce(sum(document_bytes + result_bytes), 0) FROM jobs WHERE owner = ?1),"
                    " (SELECT count(*) FROM assets WHERE owner = ?1),"
                    " (SELECT count(*) FROM projects WHERE owner = ?1),"
                    " (SELECT count(*) FROM jobs WHERE owner = ?1),"
                    " (SELECT count(*) FROM jobs WHERE owner = ?1 AND state IN (" +
                        store::unfinished_states_in_sql() +
                        ")), (SELECT coalesce(sum(document_bytes), 0) FROM versions WHERE owner = ?1)",
                    {owner}),
                usage_from, "owner", owner);
}

Result<store::Usage> SqliteStore::usage(const store::RequestContext& context) {
  const std::lock_guard hold(mutex_);
  return usage_of(context.owner);
}

Status SqliteStore::check_room(const store::OwnerId& owner, std::size_t more) {
  if (quotas_.bytes <= 0) return {};
  const store::Usage now = TRY(usage_of(owner));
  if (now.bytes + static_cast<std::int64_t>(more) <= quotas_.bytes) return {};
  return Error{"quota.bytes",
               "you keep " + megabytes(now.bytes) + " of the " + megabytes(quotas_.bytes) +
                   " that one may keep here, and this would be too much; remove drapes, projects or files",
               "", ErrorKind::kNoRoom};
}

Status SqliteStore::check_room_for_jobs(const store::OwnerId& owner, int jobs, std::size_t more) {
  TRY(check_room(owner, more));
  if (quotas_.unfinished_jobs <= 0) return {};
  const store::Usage now = TRY(usage_of(owner));
  if (now.unfinished_jobs + jobs <= quotas_.unfinished_jobs) return {};
  if (jobs > 1)
    return Error{"quota.jobs",
                 "these are " + std::to_string(jobs) + " drapes, and beside your " +
                     std::to_string(now.unfinished_jobs) + " that have not ended one may have " +
                     std::to_string(quotas_.unfinished_jobs) + " here; ask for fewer, or try again later",
                 "", ErrorKind::kTooMany};
  return Error{"quota.jobs",
               "you have " + std::to_string(now.unfinished_jobs) +
                   " drapes that have not ended, which is as many as one may have here; try again when one "
                   "has, or cancel one",
               "", ErrorKind::kTooMany};
}

Result<std::vector<store::OwnedId>> SqliteStore::jobs_ended_before(std::int64_t unix_ms, int limit) {
  const std::lock_guard hold(mutex_);
  return rows_of(
      database_.prepare("SELECT owner, id FROM jobs WHERE ended_ms > 0 AND ended_ms < ? AND state NOT IN (" +
                            store::unfinished_states_in_sql() + ") ORDER BY ended_ms LIMIT ?",
                        {unix_ms, page_limit(limit)}),
      owned_id_from);
}

Result<std::vector<std::string>> SqliteStore::files_columns(const char* table) {
  return rows_of(database_.prepare(std::string("SELECT files FROM ") + table), text_from);
}

Result<std::vector<store::OwnedId>> SqliteStore::unused_assets(std::int64_t before_ms) {
  const std::lock_guard hold(mutex_);
  std::set<std::string> used;  // of whichever owner: that an id is named says enough
  for (const char* table : {"projects", "jobs", "versions"}) {
    const std::vector<std::string> columns = TRY(files_columns(table));
    for (const std::string& column : columns) add_ids(used, column);
  }
  std::vector<store::OwnedId> old = TRY(rows_of(
      database_.prepare("SELECT owner, id FROM assets WHERE created_ms < ? ORDER BY created_ms", {before_ms}),
      owned_id_from));
  std::erase_if(old, [&](const store::OwnedId& asset) { return used.contains(asset.id); });
  return old;
}

Result<std::string> SqliteStore::job_log(const store::RequestContext& context, const std::string& job_id) {
  TRY(check_job(context.owner, job_id));
  return blobs_.log(job_id);
}

store::StoreFigures SqliteStore::figures() const {
  store::StoreFigures figures;
  figures.failures = failures_->counts();
  std::error_code unknown;
  const std::filesystem::space_info disk = std::filesystem::space(blobs_.scratch_folder(), unknown);
  if (unknown) return figures;
  figures.disk_bytes = static_cast<std::int64_t>(disk.capacity);
  figures.disk_free_bytes = static_cast<std::int64_t>(disk.available);
  return figures;
}

}  // namespace toile::sqlite
