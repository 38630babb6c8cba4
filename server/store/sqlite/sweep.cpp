#include "server/store/sqlite/sweep.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/rows.h"

namespace toile::sqlite {
namespace {

using Names = std::set<std::string>;

Names set_of(std::vector<std::string> names) { return {names.begin(), names.end()}; }

Status sweep_blobs(SqlDatabase& database, const store::Blobs& blobs) {
  Names unnamed = set_of(blobs.blob_names());  // before the rows are read, so that it can only be too few
  SqlStatement row = TRY(database.prepare("SELECT blob FROM assets"));
  for (;;) {
    const bool more = TRY(row.step());
    if (!more) break;
    unnamed.erase(row.text(0));
  }
  for (const std::string& blob : unnamed) blobs.remove_blob(blob);
  return {};
}

void keep_only(const store::Blobs& blobs, const std::string& job_id, const store::ResultFiles& named) {
  for (const std::string& name : blobs.result_names(job_id)) {
    if (!named.contains(name)) blobs.remove_result(job_id, name);
  }
}

Status sweep_results(SqlDatabase& database, const store::Blobs& blobs) {
  Names unnamed = set_of(blobs.jobs_with_results());
  SqlStatement row = TRY(database.prepare("SELECT id, results FROM jobs"));
  for (;;) {
    const bool more = TRY(row.step());
    if (!more) break;
    const std::string id = row.text(0);
    if (!unnamed.contains(id)) continue;
    const Result<store::ResultFiles> named = results_from(row.text(1), id);
    if (named && named->empty()) continue;
    unnamed.erase(id);
    if (named) keep_only(blobs, id, *named);  // a damaged row says nothing about its files
  }
  for (const std::string& id : unnamed) {
    if (Status removed = blobs.remove_results(id); !removed) continue;  // tried again at the next start
  }
  return {};
}

/// A crash between a job's end and the removal of its checkpoint leaves one.
Status sweep_checkpoints(SqlDatabase& database, const store::Blobs& blobs) {
  const std::vector<std::string> ids = TRY(rows_of(
      database.prepare("SELECT id FROM jobs WHERE state IN (" + store::unfinished_states_in_sql() + ")"),
      text_from));
  blobs.keep_checkpoints_of({ids.begin(), ids.end()});
  return {};
}

Status sweep_logs(SqlDatabase& database, const store::Blobs& blobs) {
  Names unnamed = set_of(blobs.jobs_with_logs());
  const std::vector<std::string> named = TRY(rows_of(database.prepare("SELECT id FROM jobs"), text_from));
  for (const std::string& id : named) unnamed.erase(id);
  for (const std::string& id : unnamed) blobs.remove_log(id);
  return {};
}

}  // namespace

Status sweep_files(SqlDatabase& database, const store::Blobs& blobs) {
  TRY(sweep_blobs(database, blobs));
  TRY(sweep_results(database, blobs));
  TRY(sweep_logs(database, blobs));
  return sweep_checkpoints(database, blobs);
}

}  // namespace toile::sqlite
