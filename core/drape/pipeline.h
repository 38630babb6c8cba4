#pragma once
// The one place where the order of a drape is written:
// Pattern → PanelMeshes → Assembly → ClothState → Frames → result.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/drape/drape_start.h"
#include "core/drape/frame_sink.h"
#include "core/drape/session.h"

namespace toile::drape {

/// A drape from its input to its result, in as many goes as the caller likes: between two of them it may lie
/// in memory, and any thread may take it up again. How it is cut into goes changes nothing in the result but
/// its times. Frames are recorded every `frame_interval` substeps, after a weld, and more often where the
/// drape might end before it was looked at a hundred times.
class DrapeRun {
 public:
  /// Meshes, places, checks, and records the first frame. Pieces that cannot be put on are left out:
  /// reduced() and input() tell. `input` must outlive the run; so must `sink`, which may be null. Progress
  /// phases: "mesh", "place". Errors: pattern.*, mesh.*, placement.*, start.* with the piece or seam at
  /// fault; "cancelled" when the context was cancelled on the way.
  static Result<std::unique_ptr<DrapeRun>> start(const DrapeInput& input, const RunContext& context,
                                                 FrameSink* sink);

  /// Goes on from a checkpoint of a drape of the same input: it ends in the same bytes as if it had never
  /// been broken off. Meshes, places and checks as at the start; no frame is recorded for the moment itself.
  /// Errors: those of start(); checkpoint.damaged, checkpoint.version, checkpoint.other_input.
  static Result<std::unique_ptr<DrapeRun>> resume(const DrapeInput& input, std::string_view checkpoint,
                                                  const RunContext& context, FrameSink* sink);
  /// The drape as it stands between two goes (core/drape/checkpoint.h), for resume().
  std::string checkpoint() const;

  /// A hand on the cloth, between two goes (core/drape/hands.h). Errors: those of Session::touch; live.busy
  /// while the garment is about to begin anew.
  Status touch(const Touch& touch);
  /// Does those touches again, each after the step that it came after: with the same input, the drape ends in
  /// the same bytes. Of one that goes on from how a garment hung they begin with its pins, as its log does.
  /// Errors: those of check_touches; live.method; live.order where they begin otherwise. REQUIRES that no
  /// step was made.
  Status replay(std::vector<Touch> touches);

  bool done() const { return session_->done() && !ended_badly_; }
  /// At most `max_steps` substeps: fewer when the drape is done or the context is cancelled before. Where
  /// seams do not close, or the garment does not end where it is worn, it begins anew from the next certified
  /// start, once; steps and time count on. Progress phases: "sew", "drape", "move", "dress". Gives
  /// back the number of substeps taken.
  int advance(int max_steps, const RunContext& context);
  /// What there is, finished or not; stop_reason is kCancelled for a drape that is not done. Records a last
  /// frame if the newest step was not.
  DrapeResult conclude();

  /// What is draped: the input, or that of it which could be put on (core/drape/fit_start.h).
  const DrapeInput& input() const { return reduced_ ? *reduced_ : given_; }
  bool reduced() const { return reduced_.has_value(); }
  const Session& session() const { return *session_; }
  /// How the garment hangs by now, for another drape to go on from.
  warm::HungGarment hung() const;
  /// Of the input and where its pieces stand (core/drape/input_hash.h): what a checkpoint belongs to.
  const std::string& start_hash() const { return start_hash_; }
  /// Crossings at the newest recorded frame.
  CrossingCount crossings() const { return result_.at_end; }

 private:
  DrapeRun(const DrapeInput& input, FrameSink* sink);
  void reduce(std::vector<bool> left_out, DrapeInput reduced);
  Status begin(DrapeStart start, bool on_body);
  Result<bool> go_on(const DrapeStart& start);
  Status pin_as_before(const mesh::PanelMeshes& meshes);
  Status prepare(const RunContext& context);
  Status restore(std::string_view checkpoint, const RunContext& context);
  bool ends_badly() const;
  void begin_anew(const RunContext& context);
  void tell_left_out_by_paper();
  void tell_what_is_left_open(DrapeResult& result) const;
  void tell_motion(DrapeResult& result) const;
  void tell_held(DrapeResult& result) const;
  void record_frame(Crew& crew);
  void touch_again();
  void tell_touches(DrapeResult& result) const;

  const DrapeInput& given_;
  std::optional<DrapeInput> reduced_;
  std::vector<bool> left_out_;  ///< panels of what was given; empty where it is draped whole
  FrameSink* sink_;
  std::unique_ptr<Session> session_;
  std::optional<dressing::Person> person_;
  std::string start_hash_;
  DrapeResult result_;  ///< so far: the garment, times and crossings
  int frame_interval_;  ///< steps
  int recorded_ = -1;   ///< step of the newest recorded frame
  int start_ = kSewnInPlace;
  std::vector<std::vector<std::array<Index, 2>>> facing_left_open_;  ///< core/drape/left_open.h
  std::vector<double> tops_;                                         ///< m, of each panel where it began
  bool last_start_ = false;                                          ///< no other leads on
  bool ended_badly_ = false;                                         ///< another start is to be tried
  std::string from_the_pieces_;  ///< why it does not go on from another's end
  warm::HungGarment pieces_;     ///< flat
  std::vector<Touch> to_replay_;
  std::size_t replayed_ = 0;  ///< of them
  std::string begun_anew_;    ///< why the newest was; empty while it is the first
};

/// Drapes `input` in one go, without what cannot be put on and returns the end, settled or not. `sink` may be
/// null. Progress phases: "mesh", "place", "sew", "drape". A cancelled drape is no error: it returns what
/// there is, stop_reason kCancelled; no positions when it had not begun. Errors: pattern.*, mesh.*,
/// placement.*, start.* with the piece or seam at fault.
Result<DrapeResult> drape(const DrapeInput& input, const RunContext& context, FrameSink* sink);

}  // namespace toile::drape
