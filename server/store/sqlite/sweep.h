#pragma once
// Removes what a crash or a late cancel has left in the store's folders.

#include "core/base/result.h"
#include "server/store/blobs.h"
#include "server/store/sqlite/database.h"

namespace toile::sqlite {

/// Removes blobs that no asset names, result files that their job does not name, logs of jobs
/// that are gone, and checkpoints of jobs that have ended. REQUIRES that nobody else uses the store: an
/// upload has its file before it has its row. Errors: those of reading the database; then nothing is removed
/// that was not read about.
Status sweep_files(SqlDatabase& database, const store::Blobs& blobs);

}  // namespace toile::sqlite
