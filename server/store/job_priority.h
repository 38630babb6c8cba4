#pragma once
// How urgent a job is, and the words for it.

#include <cstdint>
#include <string_view>

#include "core/base/result.h"

namespace toile::store {

enum class JobPriority : std::uint8_t {
  kInteractive,  ///< somebody looks on
  kBatch,        ///< it may wait
};

/// "interactive", "batch".
std::string_view name_of(JobPriority priority);
/// Error: store.unknown_priority, with the word as its place.
Result<JobPriority> job_priority_from(std::string_view word);

}  // namespace toile::store
