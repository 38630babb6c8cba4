#pragma once
// What becomes of a job's row when its state changes.

#include <cstdint>
#include <functional>
#include <string>

#include "server/jobs/run_end.h"
#include "server/store/store.h"

namespace toile::jobs {

using RowEdit = std::function<void(store::JobRow&)>;

/// ms since 1970: the clock that rows go by.
std::int64_t unix_ms();

/// What of a row is kept in memory and handed out: documents are large.
store::JobRow without_document(store::JobRow row);

RowEdit with_reason(std::string code, std::string reason, std::string where = "");

/// Back in the queue because the server stops.
RowEdit requeued();

/// Whoever let go of it in good order did not crash with it: that start does not count.
void uncount(store::JobRow& row);

RowEdit cancelled();

/// The end of a drape that goes on, edited, as the job `successor`.
RowEdit superseded(std::string successor);

/// What is kept of a drape whose pictures are still to be drawn. `end` must outlive the edit.
RowEdit draped(const RunEnd& end);

/// The end of a job on the same input as one that has succeeded, and whose results it shares.
RowEdit answered_by(const store::JobRow& equal);

/// What is kept at the end. `end` must outlive the edit.
RowEdit ended(const RunEnd& end);

/// The end of a drape whose pictures take the server down each time that they are drawn. REQUIRES a verdict.
RunEnd without_pictures(const store::JobRow& row);

}  // namespace toile::jobs
