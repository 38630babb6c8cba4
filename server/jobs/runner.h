#pragma once
// Drapes one job: document → cloth → stream → results in the store. Nothing that goes wrong in it reaches the
// worker.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/drape/pipeline.h"
#include "core/image/texture.h"
#include "server/documents/documents.h"
#include "server/jobs/limits.h"
#include "server/jobs/publisher.h"
#include "server/jobs/render_worker.h"
#include "server/jobs/run_end.h"
#include "server/jobs/shape_wish.h"
#include "server/jobs/stream.h"
#include "server/jobs/touch_inbox.h"
#include "server/jobs/turn.h"
#include "server/jobs/work_clock.h"
#include "server/movie/film_recorder.h"
#include "server/store/store.h"

namespace toile::jobs {

/// What a run needs of the house. All of it outlives the run.
struct RunPlace {
  documents::Documents* documents = nullptr;
  Publisher* publisher = nullptr;
  RenderWorker* renderer = nullptr;
  int stream_interval = 50;  ///< substeps between streamed frames
  std::chrono::duration<double> checkpoint_every{5};
  int still_width = 1024, still_height = 1280;  ///< pixels
  JobLimits limits;
  std::string engine;  ///< hash of the program, for the manifest
};

/// What the worker that holds a run wants of it.
struct RunControl {
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, the run lets go at the next substep
  std::function<MakeRoom()> make_room;  ///< how the drape lets go for a while, although nobody told it to
  std::function<bool()> abandon;  ///< whether even a finished drape lets go, without its pictures and results
  std::function<bool()> worth_keeping;  ///< whether a drape that lets go will be taken up again
  TouchInbox* hands = nullptr;          ///< what viewers do to the cloth
  /// Threads that may work on the drape until it is asked again: the workers' that have nothing to do. Only
  /// the worker's own time is charged; the others' nobody wanted.
  std::function<int()> threads;
  ShapeWish* shape = nullptr;                           ///< who wants to go on from how it hangs
  bool one_frame = false;                               ///< it lets go after the next streamed frame
  std::function<void(const JobProgress&)> on_progress;  ///< at most about ten times a second
  std::function<void()> on_kept;                        ///< a checkpoint: the drape has come further
  /// s that went into a phase, often: processor time, and for kStillsPhase time by the clock.
  std::function<void(std::string_view phase, double seconds)> on_worked;
  /// The drape is done, and what `end` names is in the store; its pictures are to come. An error ends the run
  /// here, as a store's does; one of kind kCancelled lets go.
  std::function<Status(const RunEnd& end)> on_draped;
};

/// A job's drape under way. Between two calls of go_on it lies in memory, or as a checkpoint in the store,
/// and any thread may call it next.
class JobRun {
 public:
  JobRun(const RunPlace& place, store::RequestContext context, std::string job_id, std::uint32_t epoch);

  /// Goes on until the end, or until it is interrupted: then it gives back nothing. Whatever is thrown inside
  /// is caught here, and the run ends with code internal.memory, internal.exception or internal.unknown.
  /// REQUIRES that it has not ended.
  std::optional<RunEnd> go_on(const RunControl& control);
  /// Keeps a checkpoint of where a drape stands that waits for its turn. REQUIRES that nobody goes on with
  /// it.
  void keep_where_it_stands();
  /// Does to a drape that waits what viewers want, and gives back its figures then. REQUIRES that nobody goes
  /// on with it.
  JobProgress touch_where_it_stands(TouchInbox& hands);
  /// How the garment hangs (warm::encode_hung), by now or at the end; empty where it is still put on or sewn.
  /// Errors: those of the store and of decode_kept, where it was put aside. REQUIRES that nobody goes on with
  /// it.
  Result<std::string> shape() const;
  /// Whether it has left memory and goes on from the store. REQUIRES that nobody goes on with it.
  bool is_aside() const { return aside_; }
  /// Processor time, s, that it took to take it up again when it had been put aside. REQUIRES as above.
  double loads_in_s() const { return loads_in_s_; }

 private:
  std::optional<RunEnd> caught(const RunControl& control);
  std::optional<RunEnd> through_all_stages(const RunControl& control);
  void account(const RunControl& control);
  Status check_limits() const;
  Status begin(const RunControl& control);
  Result<std::unique_ptr<drape::DrapeRun>> start_or_resume(const RunContext& context);
  Result<std::unique_ptr<drape::DrapeRun>> resume(std::string_view bytes, const RunContext& context);
  Status read_input();
  void keep_checkpoint(const RunControl& control);
  bool put_checkpoint(bool with_shape = false);
  bool put_aside(const RunControl& control);
  std::string shape_in_memory() const;
  Status drape_on(const RunControl& control);
  void take_touches(TouchInbox& hands);
  void let_go_of_all();
  void tell_where_it_stands(const RunControl& control);
  void advance_slice(const RunControl& control);
  Result<image::Textures> read_pictures();
  void read_pictures_into(RunEnd& end);
  Result<RunEnd> deliver_models();
  Result<RunEnd> deliver(const RunControl& control);
  Status add_stills(const RunControl& control, RunEnd& end);
  void tell(const RunControl& control, std::string_view phase, double fraction);
  void read_figures();
  RunContext context_of(const RunControl& control);

  RunPlace place_;
  store::RequestContext context_;
  std::string job_id_;
  std::uint32_t epoch_;
  bool pictures_ = true;  ///< are wanted

  std::shared_ptr<const drape::DrapeInput> whole_;  ///< what was asked for; the run refers to it
  std::shared_ptr<const drape::DrapeInput> input_;  ///< what is draped of it; pictures may outlive the run
  std::optional<movie::FilmRecorder> recorder_;     ///< the run tells it
  std::unique_ptr<drape::DrapeRun> run_;            ///< until the drape is done
  std::optional<JobStream> stream_;
  std::shared_ptr<const drape::DrapeResult> result_;  ///< from then on
  image::Textures textures_;                          ///< for who shows it
  std::optional<RunEnd> end_;                         ///< without stills, once it is in the store

  JobProgress progress_;
  WorkClock work_;       ///< of the thread that goes on with it
  double worked_s_ = 0;  ///< by all who went on with it
  bool aside_ = false;   ///< its newest checkpoint is all of the drape that there is
  double loads_in_s_ = 0;
  std::chrono::steady_clock::time_point next_aside_;  ///< not before, since the store took none
  std::chrono::steady_clock::time_point told_;
  std::chrono::steady_clock::time_point next_checkpoint_;
  int checkpoint_step_ = -1;
};

}  // namespace toile::jobs
