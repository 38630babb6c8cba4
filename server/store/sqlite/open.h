#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "server/store/store.h"

namespace toile::sqlite {

/// Opens or makes the store in `folder` (toile.db, blobs/, results/, checkpoints/, scratch/) for the one
/// server that it has. When no worker has it open as well, files that no row names go: uploads that a crash
/// has cut off, results of drapes that did not come to their end. Errors: store.open with path and reason,
/// store.in_use when another server has it open, store.other_schema when workers of another version have,
/// store.newer_schema when a newer program has written it.
Result<std::unique_ptr<store::Store>> open_sqlite_store(const std::string& folder,
                                                        const store::Quotas& quotas = {});

/// Opens the store that a server has made there, beside it and others, to work on its jobs. Errors:
/// store.open, store.other_schema when the server is of another version.
Result<std::unique_ptr<store::Store>> join_sqlite_store(const std::string& folder);

}  // namespace toile::sqlite
