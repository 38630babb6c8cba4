#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "server/store/store.h"

namespace toile::sqlite {

/// Opens or makes the store in `folder` (toile.db, blobs/, results/, checkpoints/, scratch/), which it then
/// has for itself. Files that no row names go: uploads that a crash has cut off, results of drapes that did
/// not come to their end. Errors: store.open with path and reason, store.in_use when another process has it
/// open, store.newer_schema when a newer program has written it.
Result<std::unique_ptr<store::Store>> open_sqlite_store(const std::string& folder,
                                                        const store::Quotas& quotas = {});

}  // namespace toile::sqlite
