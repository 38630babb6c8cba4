#pragma once

#include "server/jobs/publisher.h"
#include "server/store/store.h"

namespace toile::jobs {

/// What a job that is not under way has to show: its state, and the figures of its report when there is one.
JobProgress progress_of_row(const store::JobRow& row);

}  // namespace toile::jobs
