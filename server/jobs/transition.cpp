#include "server/jobs/transition.h"

#include <string>
#include <string_view>

namespace toile::jobs {
namespace {

struct Transition {
  store::JobState from;
  JobEvent event;
  store::JobState to;
  JobEffects effects;
};

using enum store::JobState;
using enum JobEvent;

/// The same wherever a worker may still hold the job.
constexpr JobEffects kEnd{.persist = true, .interrupt = true, .ends = true};
constexpr JobEffects kOutOfQueue{.persist = true};
constexpr JobEffects kLetGo{.persist = true, .interrupt = true};
constexpr JobEffects kToBack{.persist = true, .queue = QueuePlace::kBack};
constexpr JobEffects kToFront{.persist = true, .queue = QueuePlace::kFront};
constexpr JobEffects kLetGoToBack{.persist = true, .queue = QueuePlace::kBack, .interrupt = true};

/// Everything that can happen; what is not here is refused.
constexpr Transition kTable[] = {
    {kQueued, kClaim, kRunning, kOutOfQueue},
    {kQueued, kPause, kPaused, kOutOfQueue},
    {kQueued, kRequeue, kQueued, kToBack},
    {kQueued, kCancel, kCancelled, kEnd},
    {kQueued, kFinish, kSucceeded, kEnd},
    {kQueued, kFail, kFailed, kEnd},
    {kRunning, kProgress, kRunning, {}},
    {kRunning, kPause, kPaused, kLetGo},
    {kRunning, kRequeue, kQueued, kLetGoToBack},
    {kRunning, kCancel, kCancelled, kEnd},
    {kRunning, kDraped, kRunning, kOutOfQueue},
    {kRunning, kFinish, kSucceeded, kEnd},
    {kRunning, kFail, kFailed, kEnd},
    {kPaused, kResume, kQueued, kToFront},
    {kPaused, kCancel, kCancelled, kEnd},
    {kPaused, kFinish, kSucceeded, kEnd},
    {kPaused, kFail, kFailed, kEnd},
};

/// Words for "a job that is … cannot be …", in the order of the enumerators.
constexpr std::array<std::string_view, kJobEvents.size()> kEventWords{
    "taken by a worker", "reported on", "paused",
    "resumed",           "cancelled",   "said to be draped",
    "finished",          "failed",      "put back into the queue"};

Error refusal(store::JobState state, JobEvent event) {
  const std::string verb = state == kCancelled ? "was " : store::is_final(state) ? "has " : "is ";
  return {"jobs.state",
          "a job that " + verb + std::string(store::name_of(state)) + " cannot be " +
              std::string(kEventWords.at(static_cast<std::size_t>(event))),
          "", ErrorKind::kConflict};
}

}  // namespace

Result<JobTransition> next_state(store::JobState state, JobEvent event) {
  for (const Transition& row : kTable) {
    if (row.from == state && row.event == event) return JobTransition{row.to, row.effects};
  }
  return refusal(state, event);
}

}  // namespace toile::jobs
