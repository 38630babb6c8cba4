#pragma once
// Where a running drape says what happens. It does not know who listens.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/types.h"
#include "server/store/job_state.h"

namespace toile::jobs {

/// What does not change within an epoch of a job's stream: an immutable shared object.
struct StreamTopology {
  std::uint32_t epoch = 1;
  std::string bytes;  ///< the encoded topology message (proto/frames.md)
};

/// One moment of the cloth, quantised. `grid` has three int16 a vertex; seq counts from 1 within an epoch.
struct StreamFrame {
  std::uint32_t epoch = 1;
  std::uint32_t seq = 0;
  int step = 0;
  double time = 0;
  std::vector<std::int16_t> grid;
  std::string delta;  ///< encoded against seq − 1; empty for the first
};

/// The phase in which a drape's pictures are drawn, on another thread.
inline constexpr std::string_view kStillsPhase = "stills";

/// A point of the cloth that somebody has pinned.
struct LivePin {
  int number = 0;
  Vec3 place;  ///< m
};

/// Figures that go along with a running job, for progress displays.
struct JobProgress {
  store::JobState state = store::JobState::kQueued;
  std::string phase;  ///< "queued", "mesh", "dress", "sew", "drape", "stills"
  double fraction = 0;
  int step = 0;
  int first_step = 0;  ///< where this run of it began: 0, or at its checkpoint
  double simulated_s = 0;
  double rms_speed = 0;  ///< m/s
  double seam_gap_mm = 0;
  int cloth_body = 0, cloth_cloth = 0;  ///< crossings at the last recorded frame
  double step_ms = 0;                   ///< wall time per step, mean of the last slice
  int pulls = 0;                        ///< hands that hold the cloth
  std::vector<LivePin> pins;
};

/// Called by workers and by whoever asks for a change; implementations are thread-safe and must not call
/// JobService::start, stop, submit, pause, resume or cancel from inside. Of one job: topology comes before
/// its frames, frames come in order, ended is the last of a run. What topology and frame throw fails the job;
/// progress and ended must not throw.
class Publisher {
 public:
  virtual ~Publisher() = default;
  virtual void topology(const std::string& job_id, std::shared_ptr<const StreamTopology> topology) = 0;
  virtual void frame(const std::string& job_id, std::shared_ptr<const StreamFrame> frame) = 0;
  virtual void progress(const std::string& job_id, const JobProgress& progress) = 0;
  /// The job has ended or was requeued; viewers get the last word.
  virtual void ended(const std::string& job_id, const JobProgress& last) = 0;
};

}  // namespace toile::jobs
