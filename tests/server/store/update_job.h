#pragma once

#include "server/store/store.h"

namespace toile::test {

/// Writes all of a job that changes.
inline Status update_job(store::Store& store, const store::RequestContext& context,
                         const store::JobRow& row) {
  const Result<store::JobRow> kept = store.change_job(context, row.id, [&](store::JobRow& now) -> Status {
    now = row;
    return {};
  });
  return kept ? Status() : Status(kept.error());
}

}  // namespace toile::test
