#include "server/store/sqlite/open.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "server/store/sqlite/migrations.h"
#include "server/store/sqlite/read_rows.h"
#include "server/store/sqlite/store.h"
#include "server/store/sqlite/sweep.h"

namespace toile::sqlite {
namespace {

namespace fs = std::filesystem;

/// An id source that goes on after the newest id that the database has.
Result<store::IdSource> ids_after(SqlDatabase& database) {
  store::IdSource ids;
  for (const char* newest : {"SELECT max(id) FROM projects", "SELECT max(id) FROM jobs"}) {
    const std::string id = TRY(row_of(database.prepare(newest), text_from, "id", ""));
    ids.start_after(id);
  }
  return ids;
}

/// Pages that a disk has spoilt are told at the start and not by whoever meets them.
Status check_pages(SqlDatabase& database) {
  const std::string said = TRY(row_of(database.prepare("PRAGMA quick_check(1)"), text_from, "check", ""));
  if (said == "ok") return {};
  return Error{"store.corrupt", "the database is damaged (" + said + "); put back a copy of it", "",
               ErrorKind::kSystem};
}

/// The error of a part of the store as one of opening it. What a person must tell apart keeps its code.
Error opening(const fs::path& path, const Error& error) {
  if (error.kind == ErrorKind::kConflict) return placed_at(error, path.string());  // in use, or too new
  return {"store.open", error.message, path.string(), ErrorKind::kSystem};
}

}  // namespace

Result<std::unique_ptr<store::Store>> open_sqlite_store(const std::string& folder,
                                                        const store::Quotas& quotas) {
  std::error_code failure;
  const fs::path root = fs::absolute(folder, failure);
  if (fs::create_directories(root, failure)) fs::permissions(root, fs::perms::owner_all, failure);
  if (!fs::is_directory(root)) {
    return Error{"store.open", "cannot make the folder: " + failure.message(), root.string(),
                 ErrorKind::kSystem};
  }
  store::FolderLock lock = TRY(store::FolderLock::take(root));
  const auto failures = std::make_shared<store::Failures>();
  Result<store::Blobs> blobs = store::Blobs::open(root, failures);
  if (!blobs) return opening(root, blobs.error());
  const fs::path file = root / "toile.db";
  const bool had_database = fs::exists(file, failure);
  Result<SqlDatabase> database = SqlDatabase::open(file.string(), failures);
  if (!database) return opening(file, database.error());
  if (Status sound = check_pages(*database); !sound) return opening(file, sound.error());
  if (Status migrated = migrate(*database); !migrated) return opening(file, migrated.error());
  if (had_database) {  // a lost database must not take the files with it
    if (Status swept = sweep_files(*database, *blobs); !swept) return opening(file, swept.error());
  }
  const Result<store::IdSource> ids = ids_after(*database);
  if (!ids) return opening(file, ids.error());
  if (Status synced = store::sync_folder(root); !synced) return opening(root, synced.error());
  return std::unique_ptr<store::Store>(std::make_unique<SqliteStore>(
      std::move(lock), std::move(*blobs), std::move(*database), *ids, failures, quotas));
}

}  // namespace toile::sqlite
