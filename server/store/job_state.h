#pragma once
// The states of a job and their words, for everybody: rows keep the words, the service shows them, its
// clients read them. It stands in the store, the lowest room that knows jobs; how a job gets from one state
// to another is for server/jobs (transition.h) to say.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace toile::store {

enum class JobState : std::uint8_t { kQueued, kRunning, kPaused, kSucceeded, kFailed, kCancelled };
inline constexpr std::array kJobStates{JobState::kQueued,    JobState::kRunning, JobState::kPaused,
                                       JobState::kSucceeded, JobState::kFailed,  JobState::kCancelled};

/// Whether a job stays so: succeeded, failed, cancelled.
bool is_final(JobState state);

/// "queued", "running", "paused", "succeeded", "failed", "cancelled".
std::string_view name_of(JobState state);
/// Error: store.unknown_state, with the word as its place.
Result<JobState> job_state_from(std::string_view word);

/// "'queued', 'running', 'paused'": the states of jobs that have not ended, for an SQL list. It must read as
/// in the index jobs_unfinished (migrations.cpp), or SQLite does not use that.
std::string unfinished_states_in_sql();

}  // namespace toile::store
