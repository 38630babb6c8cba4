#include "server/jobs/job_state.h"

namespace toile {
namespace {

using Transition = std::optional<JobTransition>;

// In the order of the enumerators.
constexpr std::array<std::string_view, kJobStates.size()> kStateNames{"queued",    "running", "paused",
                                                                      "succeeded", "failed",  "cancelled"};
/// Words for "a job that is … cannot be …".
constexpr std::array<std::string_view, kJobEvents.size()> kEventWords{
    "taken by a worker", "reported on", "paused", "resumed",
    "cancelled",         "finished",    "failed", "put back into the queue"};

template <typename Enum, std::size_t N>
std::string_view word(const std::array<std::string_view, N>& words, Enum value) {
  return words.at(static_cast<std::size_t>(value));
}

/// The same wherever it is legal: anywhere before an end.
Transition ended_by(JobEvent event) {
  constexpr JobEffects kEnd{.persist = true, .interrupt = true, .ends = true};
  if (event == JobEvent::kCancel) return JobTransition{JobState::kCancelled, kEnd};
  if (event == JobEvent::kFinish) return JobTransition{JobState::kSucceeded, kEnd};
  if (event == JobEvent::kFail) return JobTransition{JobState::kFailed, kEnd};
  return std::nullopt;
}

Transition from_queued(JobEvent event) {
  switch (event) {
    case JobEvent::kClaim:
      return JobTransition{JobState::kRunning, {.persist = true}};
    case JobEvent::kPause:
      return JobTransition{JobState::kPaused, {.persist = true}};
    case JobEvent::kRequeue:
      return JobTransition{JobState::kQueued, {.persist = true, .queue = QueuePlace::kBack}};
    default:
      return ended_by(event);
  }
}

Transition from_running(JobEvent event) {
  switch (event) {
    case JobEvent::kProgress:
      return JobTransition{JobState::kRunning, {}};
    case JobEvent::kPause:
      return JobTransition{JobState::kPaused, {.persist = true, .interrupt = true}};
    case JobEvent::kRequeue:
      return JobTransition{JobState::kQueued,
                           {.persist = true, .queue = QueuePlace::kBack, .interrupt = true}};
    default:
      return ended_by(event);
  }
}

Transition from_paused(JobEvent event) {
  switch (event) {
    case JobEvent::kResume:
      return JobTransition{JobState::kQueued, {.persist = true, .queue = QueuePlace::kFront}};
    case JobEvent::kRequeue:
      return JobTransition{JobState::kQueued,
                           {.persist = true, .queue = QueuePlace::kBack, .interrupt = true}};
    default:
      return ended_by(event);
  }
}

Transition transition(JobState state, JobEvent event) {
  switch (state) {
    case JobState::kQueued:
      return from_queued(event);
    case JobState::kRunning:
      return from_running(event);
    case JobState::kPaused:
      return from_paused(event);
    case JobState::kSucceeded:
    case JobState::kFailed:
    case JobState::kCancelled:
      break;
  }
  return std::nullopt;
}

}  // namespace

Result<JobTransition> next_state(JobState state, JobEvent event) {
  if (const Transition found = transition(state, event)) return *found;
  const std::string verb = state == JobState::kCancelled ? "was " : is_terminal(state) ? "has " : "is ";
  const std::string message = "a job that " + verb + std::string(name_of(state)) + " cannot be " +
                              std::string(word(kEventWords, event));
  return Error{"jobs.state", message, ""};
}

bool is_terminal(JobState state) {
  return state == JobState::kSucceeded || state == JobState::kFailed || state == JobState::kCancelled;
}

std::string_view name_of(JobState state) { return word(kStateNames, state); }

std::optional<JobState> job_state_from(std::string_view name) {
  for (const JobState state : kJobStates) {
    if (name == name_of(state)) return state;
  }
  return std::nullopt;
}

}  // namespace toile
