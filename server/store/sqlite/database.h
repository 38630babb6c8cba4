#pragma once
// SQLite as values that clean up after themselves. Not thread-safe: whoever has a connection guards it.

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/base/result.h"
#include "server/store/failures.h"

struct sqlite3;
struct sqlite3_stmt;

namespace toile::sqlite {

/// What a question mark in a statement stands for. Text is copied.
using SqlValue = std::variant<std::nullptr_t, std::int64_t, std::string_view>;

/// A prepared statement with its values.
class SqlStatement {
 public:
  /// True when a row is there to be read, false when there are no more.
  Result<bool> step();
  /// Of the present row, by column from 0; 0 or empty where the column is null.
  std::int64_t integer(int column) const;
  std::string text(int column) const;

 private:
  friend class SqlDatabase;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  std::shared_ptr<store::Failures> failures_;
};

/// A connection. Errors of its calls: store.full, store.busy, store.corrupt, store.failed.
class SqlDatabase {
 public:
  /// Opens or makes the file with a write-ahead log, and each commit waits until the disk has it.
  /// What fails is counted in `failures`.
  static Result<SqlDatabase> open(const std::string& path, std::shared_ptr<store::Failures> failures =
                                                               std::make_shared<store::Failures>());

  Result<SqlStatement> prepare(std::string_view sql, std::initializer_list<SqlValue> values = {});
  /// Runs one statement to its end and tells how many rows it changed.
  Result<int> run(std::string_view sql, std::initializer_list<SqlValue> values = {});
  /// Runs several statements without values.
  Status run_script(const char* sql);
  /// SQLite ends one by itself where the disk is full, say.
  bool in_transaction() const;

 private:
  friend class SqlTransaction;
  struct Close {
    void operator()(sqlite3* database) const;
  };
  Error failure(int system_reason = 0) const;
  std::unique_ptr<sqlite3, Close> database_;
  std::shared_ptr<store::Failures> failures_;
};

/// All or nothing: what is not committed when this goes is undone.
class SqlTransaction {
 public:
  /// REQUIRES: `database` outlives this and has no other transaction.
  static Result<SqlTransaction> begin(SqlDatabase& database);
  SqlTransaction(SqlTransaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
  SqlTransaction& operator=(SqlTransaction&&) = delete;
  ~SqlTransaction();
  Status commit();

 private:
  explicit SqlTransaction(SqlDatabase& database) : database_(&database) {}
  SqlDatabase* database_;
};

}  // namespace toile::sqlite
