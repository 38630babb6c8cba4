#pragma once
// The one place where the order of a drape is written:
// Pattern → PanelMeshes → Assembly → ClothState → Frames → result.

#include <memory>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/drape/frame_sink.h"
#include "core/drape/session.h"

namespace toile {

/// A drape from its input to its result, in as many goes as the caller likes: between two of them it may lie
/// in memory, and any thread may take it up again. How it is cut into goes changes nothing in the result but
/// its times.
class DrapeRun {
 public:
  /// Meshes, places, checks, and records the first frame. `input` must outlive the run; so must `sink`, which
  /// may be null. Progress phases: "mesh", "place". Errors: pattern.*, mesh.*, placement.*, start.* with the
  /// piece or seam at fault; "cancelled" when the context was cancelled on the way.
  static Result<std::unique_ptr<DrapeRun>> start(const DrapeInput& input, const RunContext& context,
                                                 FrameSink* sink);

  bool done() const { return session_->done(); }
  /// At most `max_steps` substeps: fewer when the drape is done or the context is cancelled before. Progress
  /// phases: "sew", "drape". Gives back the number of substeps taken.
  int advance(int max_steps, const RunContext& context);
  /// What there is, finished or not; stop_reason is "cancelled" for a drape that is not done. Records a last
  /// frame if the newest step was not.
  DrapeResult conclude();

  const DrapeSession& session() const { return *session_; }
  /// Crossings at the newest recorded frame.
  CrossingCount crossings() const { return result_.at_end; }

 private:
  DrapeRun(const DrapeInput& input, FrameSink* sink) : input_(input), sink_(sink) {}
  Status prepare(const RunContext& context);
  void record_frame();

  const DrapeInput& input_;
  FrameSink* sink_;
  std::unique_ptr<DrapeSession> session_;
  DrapeResult result_;  ///< so far: the garment, times and crossings
  int recorded_ = -1;   ///< step of the newest recorded frame
};

/// Drapes `input` in one go and returns the end, settled or not. `sink` may be null. Progress phases: "mesh",
/// "place", "sew", "drape". A cancelled drape is no error: it returns what there is, stop_reason "cancelled";
/// no positions when it had not begun. Errors: pattern.*, mesh.*, placement.*, start.* with the piece or seam
/// at fault.
Result<DrapeResult> drape(const DrapeInput& input, const RunContext& context, FrameSink* sink);

}  // namespace toile
