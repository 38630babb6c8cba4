#pragma once

#include <string>

#include "server/jobs/publisher.h"
#include "server/store/store.h"

namespace toile::jobs {

/// What a job that is not under way in this process has to show: its state, and the figures of its report or
/// of what its holder told last.
JobProgress progress_of_row(const store::JobRow& row);

/// What the holder of a job tells of it, as its row keeps it.
std::string text_of(const JobProgress& progress);

}  // namespace toile::jobs
