#include "server/store/job_priority.h"

#include <string>

namespace toile::store {

std::string_view name_of(JobPriority priority) {
  return priority == JobPriority::kInteractive ? "interactive" : "batch";
}

Result<JobPriority> job_priority_from(std::string_view word) {
  for (const JobPriority priority : {JobPriority::kInteractive, JobPriority::kBatch}) {
    if (name_of(priority) == word) return priority;
  }
  return Error{"store.unknown_priority", "a priority is \"interactive\" or \"batch\"", std::string(word)};
}

}  // namespace toile::store
