#pragma once
// Rows of the database as the plain values of store.h.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/store/sqlite/database.h"
#include "server/store/store.h"
#include "server/store/sweeps.h"

namespace toile::sqlite {

/// ProjectRow::files.
using FileIds = std::map<std::string, std::string>;

// What a SELECT must ask for, in the order in which the readers below take it.
inline constexpr const char* kAssetColumns = "id, kind, name, size, created_ms, info";
inline constexpr const char* kProjectColumns = "id, name, revision, created_ms, updated_ms, files, document";
inline constexpr const char* kJobColumns =
    "id, project_id, project_revision, name, state, reason_code, reason, reason_where, attempt, created_ms, "
    "started_ms, ended_ms, results, files, report, document, notes, verdict, worked_ms, priority, input, "
    "suspect, holder, lease, lease_until_ms, progress, sweep, sweep_body, sweep_fabric, pictures";
/// The same without the document.
inline constexpr const char* kJobListColumns =
    "id, project_id, project_revision, name, state, reason_code, reason, reason_where, attempt, created_ms, "
    "started_ms, ended_ms, results, files, report, '', notes, verdict, worked_ms, priority, input, "
    "suspect, holder, lease, lease_until_ms, progress, sweep, sweep_body, sweep_fabric, pictures";
inline constexpr const char* kSweepColumns =
    "id, project_id, project_revision, name, created_ms, bodies, fabrics";
/// How many columns a job has: where one more may stand.
inline constexpr int kJobColumnCount = 30;

/// Error of each: store.corrupt.
Result<store::AssetRow> asset_from(const SqlStatement& row);
Result<store::ProjectRow> project_from(const SqlStatement& row);
Result<store::JobRow> job_from(const SqlStatement& row);
/// Of kSweepColumns.
Result<store::SweepRow> sweep_from(const SqlStatement& row);

/// A map as the JSON object that its column keeps.
std::string column_text(const FileIds& files);
std::string column_text(const store::ResultFiles& results);
/// What rows or columns of a sweep are called, as a JSON list.
std::string column_text(const std::vector<std::string>& labels);
/// JobRow::notes as a JSON list, JobRow::verdict as an object or an empty text.
std::string column_text(const std::vector<store::JobNote>& notes);
std::string column_text(const std::optional<store::JobVerdict>& verdict);
/// And back; `thing` names the row. Errors: store.corrupt.
Result<FileIds> files_from(const std::string& text, const std::string& thing);
/// And back; `thing` names the row. Error: store.corrupt.
Result<store::ResultFiles> results_from(const std::string& text, const std::string& thing);

}  // namespace toile::sqlite
