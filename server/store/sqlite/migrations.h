#pragma once
// How the database came to its present shape: numbered steps, of which a file remembers those it has been
// through.

#include <span>

#include "core/base/result.h"
#include "server/store/sqlite/database.h"

namespace toile::sqlite {

/// A step once released never changes; what comes later is a step of its own.
struct Migration {
  int number;        ///< 1, 2, 3, … without gaps
  const char* name;  ///< for people
  const char* sql;
};

std::span<const Migration> migrations();

/// That the database has been through all of them already. Error: store.other_schema.
Status check_schema(SqlDatabase& database, std::span<const Migration> steps = migrations());

/// Takes the database through those of `steps` that it has not been through, each whole or not at all.
/// Errors: store.newer_schema when the database knows a step that this program does not; those of
/// SqlDatabase.
Status migrate(SqlDatabase& database, std::span<const Migration> steps = migrations());

}  // namespace toile::sqlite
