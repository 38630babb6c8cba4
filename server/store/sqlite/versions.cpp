// Versions of projects, and which drapes were made of them.

#include "server/store/versions.h"

#include <cstdint>
#include <utility>

#include "server/store/now.h"
#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/rows.h"
#include "server/store/sqlite/store.h"

namespace toile::sqlite {
namespace {

constexpr const char* kVersionColumns = "id, project_id, name, revision, created_ms, files, document, line";
/// Of the same state: the text as it was named, or as edits write it, and no file is another. There may be
/// more files: those that edits brought stay when they are undone.
constexpr const char* kSame =
    "(x.document = v.document OR (v.line <> '' AND x.document = v.line)) AND NOT EXISTS"
    " (SELECT 1 FROM json_each(v.files) a JOIN json_each(x.files) b ON a.key = b.key WHERE a.value <> "
    "b.value)";

Result<store::VersionRow> version_from(const SqlStatement& row) {
  store::VersionRow version;
  version.id = row.text(0);
  version.project_id = row.text(1);
  version.name = row.text(2);
  version.revision = static_cast<int>(row.integer(3));
  version.created_ms = row.integer(4);
  version.files = TRY(files_from(row.text(5), version.id));
  version.document = row.text(6);
  version.line = row.text(7);
  return version;
}

Result<store::ToldVersion> told_from(const SqlStatement& row) {
  store::ToldVersion told;
  told.version = TRY(version_from(row));
  told.current = row.integer(8) != 0;
  return told;
}

Result<std::pair<std::string, std::string>> drape_from(const SqlStatement& row) {
  return std::pair(row.text(0), row.text(1));
}

}  // namespace

Result<store::VersionRow> SqliteStore::add_version(const store::RequestContext& context,
                                                   store::VersionRow row, int expected) {
  const std::lock_guard hold(mutex_);
  SqlTransaction transaction = TRY(SqlTransaction::begin(database_));
  const store::ProjectRow now = TRY(find_project(context.owner, row.project_id));
  TRY(check_revision(now, expected));
  const std::int64_t there =
      TRY(row_of(database_.prepare("SELECT count(*) FROM versions WHERE owner = ? AND project_id = ?",
                                   {context.owner, row.project_id}),
                 count_from, "project", row.project_id));
  if (there >= kMostVersions)
    return Error{
        "versions.too_many",
        "the project has " + std::to_string(kMostVersions) + " versions; remove some that are not needed", "",
        ErrorKind::kConflict};
  const std::int64_t taken = TRY(row_of(
      database_.prepare("SELECT count(*) FROM versions WHERE owner = ? AND project_id = ? AND name = ?",
                        {context.owner, row.project_id, row.name}),
      count_from, "project", row.project_id));
  if (taken > 0)
    return Error{"versions.taken", "there is a version of that name; take another name, or remove that one",
                 "/name", ErrorKind::kConflict};
  const std::size_t bytes = row.document.size() + row.line.size();
  TRY(check_room(context.owner, bytes));
  row.created_ms = store::now_ms();
  row.id = TRY(ids_.next('v', row.created_ms));
  TRY(database_.run(
      "INSERT INTO versions (owner, project_id, id, name, revision, created_ms, document, line, files,"
      " document_bytes) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      {context.owner, row.project_id, row.id, row.name, std::int64_t{row.revision}, row.created_ms,
       row.document, row.line, column_text(row.files), static_cast<std::int64_t>(bytes)}));
  TRY(transaction.commit());
  return row;
}

Result<store::VersionRow> SqliteStore::version(const store::RequestContext& context,
                                               const std::string& project_id, const std::string& id) {
  const std::lock_guard hold(mutex_);
  return row_of(database_.prepare(
                    select(kVersionColumns, "FROM versions WHERE owner = ? AND project_id = ? AND id = ?"),
                    {context.owner, project_id, id}),
                version_from, "version", id);
}

Result<std::vector<store::ToldVersion>> SqliteStore::versions(const store::RequestContext& context,
                                                              const std::string& project_id) {
  const std::lock_guard hold(mutex_);
  TRY(find_project(context.owner, project_id));
  const std::string same(kSame);
  std::vector<store::ToldVersion> told = TRY(rows_of(
      database_.prepare("SELECT v.id, v.project_id, v.name, v.revision, v.created_ms, v.files, '', '',"
                        " EXISTS (SELECT 1 FROM projects x WHERE x.owner = v.owner AND x.id = v.project_id"
                        " AND " +
                            same +
                            ")"
                            " FROM versions v WHERE v.owner = ? AND v.project_id = ? ORDER BY v.id DESC",
                        {context.owner, project_id}),
      told_from));
  const std::vector<std::pair<std::string, std::string>> drapes =
      TRY(rows_of(database_.prepare("SELECT v.id, x.id FROM versions v JOIN jobs x ON x.owner = v.owner"
                                    " AND x.project_id = v.project_id AND " +
                                        same + " WHERE v.owner = ? AND v.project_id = ? ORDER BY x.id DESC",
                                    {context.owner, project_id}),
                  drape_from));
  for (const auto& [version, job] : drapes)
    for (store::ToldVersion& one : told)
      if (one.version.id == version) one.jobs.push_back(job);
  return told;
}

Status SqliteStore::remove_version(const store::RequestContext& context, const std::string& project_id,
                                   const std::string& id) {
  const std::lock_guard hold(mutex_);
  const int gone = TRY(database_.run("DELETE FROM versions WHERE owner = ? AND project_id = ? AND id = ?",
                                     {context.owner, project_id, id}));
  return gone > 0 ? Status() : Status(not_found("version", id));
}

}  // namespace toile::sqlite
