#include "server/store/sqlite/open.h"

#include <filesystem>
#include <optional>
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
  for (const char* newest : {"SELECT max(id) FROM projects", "SELECT max(id) FROM jobs",
                             "SELECT max(id) FROM accounts WHERE id LIKE 'u%'", "SELECT max(id) FROM keys",
                             "SELECT max(id) FROM links", "SELECT max(id) FROM sweeps"}) {
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

/// The folder as an absolute path, made when it is not there.
Result<fs::path> made(const std::string& folder) {
  std::error_code failure;
  const fs::path root = fs::absolute(folder, failure);
  if (fs::create_directories(root, failure)) fs::permissions(root, fs::perms::owner_all, failure);
  if (fs::is_directory(root)) return root;
  return Error{"store.open", "cannot make the folder: " + failure.message(), root.string(),
               ErrorKind::kSystem};
}

/// What a process has of a folder.
struct Opening {
  fs::path root;
  std::optional<store::FolderLock> server;  ///< of the one that serves
  store::FolderLock shared;
  bool alone = false;  ///< nobody else may come in before it is open
};

/// Steps and files are for whoever is alone. A lost database must not take the files with it.
Status put_in_order(SqlDatabase& database, const store::Blobs& blobs, bool alone, bool had_database) {
  if (!alone) return check_schema(database);
  TRY(migrate(database));
  if (had_database) {
    TRY(sweep_files(database, blobs));
  }
  return {};
}

Result<std::unique_ptr<store::Store>> open_in(Opening opened, const store::Quotas& quotas) {
  const fs::path& root = opened.root;
  const auto failures = std::make_shared<store::Failures>();
  Result<store::Blobs> blobs = store::Blobs::open(root, failures, opened.alone);
  if (!blobs) return opening(root, blobs.error());
  store::Holder holder = TRY(store::Holder::join(root));
  const fs::path file = root / "toile.db";
  std::error_code failure;
  const bool had_database = fs::exists(file, failure);
  Result<SqlDatabase> database = SqlDatabase::open(file.string(), failures);
  if (!database) return opening(file, database.error());
  if (Status sound = check_pages(*database); !sound) return opening(file, sound.error());
  if (Status order = put_in_order(*database, *blobs, opened.alone, had_database); !order)
    return opening(file, order.error());
  if (opened.alone) holder.sweep();
  const Result<store::IdSource> ids = ids_after(*database);
  if (!ids) return opening(file, ids.error());
  if (Status synced = store::sync_folder(root); !synced) return opening(root, synced.error());
  opened.shared.share_again();
  SqliteStore::Locks locks{std::move(opened.server), std::move(opened.shared), std::move(holder)};
  return std::unique_ptr<store::Store>(std::make_unique<SqliteStore>(
      std::move(locks), std::move(*blobs), std::move(*database), *ids, failures, quotas));
}

}  // namespace

Result<std::unique_ptr<store::Store>> open_sqlite_store(const std::string& folder,
                                                        const store::Quotas& quotas) {
  const fs::path root = TRY(made(folder));
  store::FolderLock lock = TRY(store::FolderLock::take(root));
  store::FolderLock shared = TRY(store::FolderLock::share(root));
  const bool alone = shared.try_alone();
  return open_in({root, std::move(lock), std::move(shared), alone}, quotas);
}

Result<std::unique_ptr<store::Store>> join_sqlite_store(const std::string& folder) {
  std::error_code failure;
  const fs::path root = fs::absolute(folder, failure);
  if (!fs::exists(root / "toile.db", failure)) {
    return Error{"store.open", "there is no store here; start the server first", root.string(),
                 ErrorKind::kSystem};
  }
  store::FolderLock shared = TRY(store::FolderLock::share(root));
  return open_in({root, std::nullopt, std::move(shared), false}, {});
}

}  // namespace toile::sqlite
