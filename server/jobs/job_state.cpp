#include "server/jobs/job_state.h"

namespace toile {
namespace {

using Transition = std::optional<JobTransition>;

/// Words for "a job that is … cannot be …".
std::string_view words_for(JobEvent event) {
  switch (event) {
    case JobEvent::kClaim:
      return "taken by a worker";
    case JobEvent::kProgress:
      return "reported on";
    case JobEvent::kPause:
      return "paused";
    case JobEvent::kResume:
      return "resumed";
    case JobEvent::kCancel:
      return "cancelled";
    case JobEvent::kFinish:
      return "finished";
    case JobEvent::kFail:
      return "failed";
    case JobEvent::kRequeue:
      return "put back into the queue";
  }
  return "changed";
}

JobTransition ended(JobState state) { return {state, {.persist = true, .interrupt = true, .ends = true}}; }

Transition from_queued(JobEvent event) {
  switch (event) {
    case JobEvent::kClaim:
      return JobTransition{JobState::kRunning, {.persist = true}};
    case JobEvent::kPause:
      return JobTransition{JobState::kPaused, {.persist = true}};
    case JobEvent::kCancel:
      return ended(JobState::kCancelled);
    case JobEvent::kFinish:
      return ended(JobState::kSucceeded);
    case JobEvent::kFail:
      return ended(JobState::kFailed);
    case JobEvent::kRequeue:
      return JobTransition{JobState::kQueued, {.persist = true, .queue = QueuePlace::kBack}};
    case JobEvent::kProgress:
    case JobEvent::kResume:
      break;
  }
  return std::nullopt;
}

Transition from_running(JobEvent event) {
  switch (event) {
    case JobEvent::kProgress:
      return JobTransition{JobState::kRunning, {}};
    case JobEvent::kPause:
      return JobTransition{JobState::kPaused, {.persist = true, .interrupt = true}};
    case JobEvent::kCancel:
      return ended(JobState::kCancelled);
    case JobEvent::kFinish:
      return ended(JobState::kSucceeded);
    case JobEvent::kFail:
      return ended(JobState::kFailed);
    case JobEvent::kRequeue:
      return JobTransition{JobState::kQueued,
                           {.persist = true, .queue = QueuePlace::kBack, .interrupt = true}};
    case JobEvent::kClaim:
    case JobEvent::kResume:
      break;
  }
  return std::nullopt;
}

Transition from_paused(JobEvent event) {
  switch (event) {
    case JobEvent::kResume:
      return JobTransition{JobState::kQueued, {.persist = true, .queue = QueuePlace::kFront}};
    case JobEvent::kCancel:
      return ended(JobState::kCancelled);
    case JobEvent::kFinish:
      return ended(JobState::kSucceeded);
    case JobEvent::kFail:
      return ended(JobState::kFailed);
    case JobEvent::kRequeue:
      return JobTransition{JobState::kQueued,
                           {.persist = true, .queue = QueuePlace::kBack, .interrupt = true}};
    case JobEvent::kClaim:
    case JobEvent::kProgress:
    case JobEvent::kPause:
      break;
  }
  return std::nullopt;
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
  const std::string message =
      "a job that " + verb + std::string(name_of(state)) + " cannot be " + std::string(words_for(event));
  return Error{"jobs.state", message, ""};
}

bool is_terminal(JobState state) {
  return state == JobState::kSucceeded || state == JobState::kFailed || state == JobState::kCancelled;
}

std::string_view name_of(JobState state) {
  switch (state) {
    case JobState::kQueued:
      return "queued";
    case JobState::kRunning:
      return "running";
    case JobState::kPaused:
      return "paused";
    case JobState::kSucceeded:
      return "succeeded";
    case JobState::kFailed:
      return "failed";
    case JobState::kCancelled:
      return "cancelled";
  }
  return "";
}

std::optional<JobState> job_state_from(std::string_view name) {
  for (const JobState state : kJobStates) {
    if (name == name_of(state)) return state;
  }
  return std::nullopt;
}

}  // namespace toile
