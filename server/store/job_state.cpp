#include "server/store/job_state.h"

namespace toile::store {
namespace {

struct StateRow {
  JobState state;
  std::string_view word;
  bool final;
};

// A row for every state, in the order of the enumerators.
constexpr std::array<StateRow, kJobStates.size()> kTable{{{JobState::kQueued, "queued", false},
                                                          {JobState::kRunning, "running", false},
                                                          {JobState::kPaused, "paused", false},
                                                          {JobState::kSucceeded, "succeeded", true},
                                                          {JobState::kFailed, "failed", true},
                                                          {JobState::kCancelled, "cancelled", true}}};

const StateRow& row_of(JobState state) { return kTable.at(static_cast<std::size_t>(state)); }

}  // namespace

bool is_final(JobState state) { return row_of(state).final; }

std::string_view name_of(JobState state) { return row_of(state).word; }

Result<JobState> job_state_from(std::string_view word) {
  for (const StateRow& row : kTable) {
    if (row.word == word) return row.state;
  }
  return Error{"store.unknown_state", "this version knows no such state of a job", std::string(word),
               ErrorKind::kSystem};
}

std::string unfinished_states_in_sql() {
  std::string list;
  for (const StateRow& row : kTable) {
    if (row.final) continue;
    list += (list.empty() ? "'" : ", '") + std::string(row.word) + "'";
  }
  return list;
}

}  // namespace toile::store
