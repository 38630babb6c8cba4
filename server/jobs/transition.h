#pragma once
// How a job changes: a pure function of its state and what happened. Whoever calls it carries out the
// effects.
//
//                     claim                  finish
//   submit ─▶ queued ─────────▶ running ─────────────▶ succeeded
//             │ ▲ ▲             │ │ │ ▲│ progress
//             │ │ └── requeue ──┘ │ │ └┘ draped
//             │ │                 │ └── fail ─────────▶ failed
//       pause │ │ resume          │ pause
//             ▼ │                 ▼                      cancelled ◀── cancel ── queued, running, paused
//             paused ◀────────────┘
//
// requeue: a drain takes the job from its worker, a start finds it cut off, or it makes room for one that is
// to run alone. What is paused stays so over stops and crashes.
//
// The worker that drapes learns of a pause or a cancel up to 50 ms after the state has changed. Until then it
// may come with its end: finish and fail are therefore legal wherever a worker may still hold the job, that
// is also from paused and from queued (paused, then resumed at once). After cancel the end comes too late and
// is refused. Final states have no way out.

#include <array>

#include "core/base/result.h"
#include "server/store/job_state.h"

namespace toile::jobs {

enum class JobEvent : std::uint8_t {
  kClaim,     ///< a worker takes it
  kProgress,  ///< the worker tells how far it is
  kPause,
  kResume,
  kCancel,
  kDraped,   ///< the drape has ended and its models are kept; its pictures are to come
  kFinish,   ///< all that there will be is kept
  kFail,     ///< it cannot be draped, or something broke
  kRequeue,  ///< it is taken from its worker, or a start finds it cut off
};
inline constexpr std::array kJobEvents{JobEvent::kClaim,  JobEvent::kProgress, JobEvent::kPause,
                                       JobEvent::kResume, JobEvent::kCancel,   JobEvent::kDraped,
                                       JobEvent::kFinish, JobEvent::kFail,     JobEvent::kRequeue};

/// Where in the queue a job comes to stand.
enum class QueuePlace : std::uint8_t { kOut, kFront, kBack };

/// What has to be done when a job changes.
struct JobEffects {
  bool persist = false;                 ///< write the row before anybody is told
  QueuePlace queue = QueuePlace::kOut;  ///< kOut: it does not stand in the queue afterwards
  bool interrupt = false;               ///< tell the worker that may hold it to let go
  bool ends = false;                    ///< viewers get the last word
  friend bool operator==(const JobEffects&, const JobEffects&) = default;
};

struct JobTransition {
  store::JobState state = store::JobState::kQueued;
  JobEffects effects;
};

/// Error: jobs.state, with words for a person, when `event` cannot happen in `state`.
Result<JobTransition> next_state(store::JobState state, JobEvent event);

}  // namespace toile::jobs
