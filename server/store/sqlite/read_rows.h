#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/log.h"
#include "core/base/names.h"
#include "core/base/result.h"
#include "server/store/sqlite/database.h"

namespace toile::sqlite {

/// What belongs to somebody else is not found either, in the same words.
inline Error not_found(const char* thing, const std::string& id) {
  return {"store.not_found", std::string("there is no ") + thing + " " + in_quotes(id), "",
          ErrorKind::kNotFound};
}

inline std::string select(const char* columns, const char* rest) {
  return std::string("SELECT ") + columns + " " + rest;
}

inline Result<std::int64_t> count_from(const SqlStatement& row) { return row.integer(0); }
inline Result<std::string> text_from(const SqlStatement& row) { return row.text(0); }

/// All rows of a statement, each read by `read`.
template <typename Row>
Result<std::vector<Row>> rows_of(Result<SqlStatement> made, Result<Row> (*read)(const SqlStatement&)) {
  SqlStatement statement = TRY(std::move(made));
  std::vector<Row> rows;
  for (;;) {
    const bool more = TRY(statement.step());
    if (!more) return rows;
    Row row = TRY(read(statement));
    rows.push_back(std::move(row));
  }
}

/// The same for a list that somebody looks through: a damaged row is passed over, with a line in the log, so
/// that it hides none of the others.
template <typename Row>
Result<std::vector<Row>> readable_rows_of(Result<SqlStatement> made, Result<Row> (*read)(const SqlStatement&),
                                          const Log& log) {
  SqlStatement statement = TRY(std::move(made));
  std::vector<Row> rows;
  for (;;) {
    const bool more = TRY(statement.step());
    if (!more) return rows;
    Result<Row> row = read(statement);
    if (row) {
      rows.push_back(std::move(*row));
    } else {
      log.error("a row of the database is passed over",
                {{"code", row.error().code}, {"row", row.error().where}});
    }
  }
}

/// The one row of a statement, or store.not_found.
template <typename Row>
Result<Row> row_of(Result<SqlStatement> statement, Result<Row> (*read)(const SqlStatement&),
                   const char* thing, const std::string& id) {
  std::vector<Row> rows = TRY(rows_of(std::move(statement), read));
  if (rows.empty()) return not_found(thing, id);
  return std::move(rows.front());
}

}  // namespace toile::sqlite
