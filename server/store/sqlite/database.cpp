#include "server/store/sqlite/database.h"

#include <sqlite3.h>

#include <cerrno>
#include <climits>

namespace toile::sqlite {
namespace {

/// How long a statement waits for another process (a backup, say) that holds the file.
constexpr int kBusyTimeoutMs = 5000;

/// SQLite has a code of its own for ENOSPC when it writes, and calls a quota, a limit on files, or no room
/// for the log's index a failure of the disk; sqlite3_system_errno is not set by a step.
bool out_of_room(int code, int reason) {
  return code == SQLITE_FULL ||
         (code == SQLITE_IOERR && (reason == ENOSPC || reason == EDQUOT || reason == EFBIG));
}

/// What the connection's last call says went wrong; `system_reason` is errno after it, where it was 0 before.
Error error_of(sqlite3* database, int system_reason) {
  const int code = sqlite3_errcode(database) & 0xff;
  const std::string reason = sqlite3_errmsg(database);
  if (out_of_room(code, system_reason)) {
    return {"store.full", "the disk has no room for this; free some and try again", "", ErrorKind::kNoRoom};
  }
  if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
    return {"store.busy", "another program holds the database; try again", "", ErrorKind::kUnavailable};
  }
  if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) {
    return {"store.corrupt", "the database file is damaged: " + reason, "", ErrorKind::kSystem};
  }
  return {"store.failed", "the database says: " + reason, "", ErrorKind::kSystem};
}

int bind(sqlite3_stmt* statement, int place, const SqlValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    return sqlite3_bind_int64(statement, place, *integer);
  }
  if (const auto* text = std::get_if<std::string_view>(&value)) {
    const char* begin = text->data() != nullptr ? text->data() : "";  // a null pointer would mean NULL
    return sqlite3_bind_text64(statement, place, begin, text->size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  }
  return sqlite3_bind_null(statement, place);
}

/// The file system may be one that cannot share memory, where SQLite quietly stays with its older journal.
Status use_write_ahead_log(SqlDatabase& database) {
  SqlStatement mode = TRY(database.prepare("PRAGMA journal_mode=WAL"));
  const bool row = TRY(mode.step());
  if (row && mode.text(0) == "wal") return {};
  return Error{"store.failed", "this file system does not allow a write-ahead log; use a local disk", "",
               ErrorKind::kSystem};
}

}  // namespace

void SqlStatement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
void SqlDatabase::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

Result<bool> SqlStatement::step() {
  errno = 0;
  const int code = sqlite3_step(statement_.get());
  const int reason = errno;
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return failures_->counted(error_of(sqlite3_db_handle(statement_.get()), reason));
}

std::int64_t SqlStatement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string SqlStatement::text(int column) const {
  const auto* begin = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return begin == nullptr ? std::string() : std::string(begin, static_cast<std::size_t>(size));
}

Error SqlDatabase::failure(int system_reason) const {
  return failures_->counted(error_of(database_.get(), system_reason));
}

Result<SqlDatabase> SqlDatabase::open(const std::string& path, std::shared_ptr<store::Failures> failures) {
  SqlDatabase made;
  made.failures_ = std::move(failures);
  sqlite3* raw = nullptr;
  constexpr int kFlags =
      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  const int code = sqlite3_open_v2(path.c_str(), &raw, kFlags, nullptr);
  made.database_.reset(raw);
  if (raw == nullptr)
    return Error{"store.failed", "there is no memory for a connection", path, ErrorKind::kSystem};
  if (code != SQLITE_OK) return made.failure();
  sqlite3_busy_timeout(raw, kBusyTimeoutMs);
  TRY(use_write_ahead_log(made));
  TRY(made.run_script("PRAGMA synchronous=FULL; PRAGMA foreign_keys=ON"));
  return made;
}

Result<SqlStatement> SqlDatabase::prepare(std::string_view sql, std::initializer_list<SqlValue> values) {
  SqlStatement made;
  made.failures_ = failures_;
  sqlite3_stmt* raw = nullptr;
  if (sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()), &raw, nullptr) !=
      SQLITE_OK) {
    return failure();
  }
  made.statement_.reset(raw);
  int place = 0;
  for (const SqlValue& value : values) {
    if (bind(raw, ++place, value) != SQLITE_OK) return failure();
  }
  return made;
}

Result<int> SqlDatabase::run(std::string_view sql, std::initializer_list<SqlValue> values) {
  SqlStatement statement = TRY(prepare(sql, values));
  for (;;) {
    const bool row = TRY(statement.step());
    if (!row) return sqlite3_changes(database_.get());
  }
}

Status SqlDatabase::run_script(const char* sql) {
  errno = 0;
  const int code = sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
  const int reason = errno;
  if (code == SQLITE_OK) return {};
  return failure(reason);
}

bool SqlDatabase::in_transaction() const { return sqlite3_get_autocommit(database_.get()) == 0; }

Result<SqlTransaction> SqlTransaction::begin(SqlDatabase& database) {
  TRY(database.run_script("BEGIN IMMEDIATE"));
  return SqlTransaction(database);
}

SqlTransaction::~SqlTransaction() {
  if (database_ == nullptr || !database_->in_transaction()) return;
  sqlite3_exec(database_->database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

Status SqlTransaction::commit() { return database_->run_script("COMMIT"); }

}  // namespace toile::sqlite
