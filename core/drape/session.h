#pragma once
// One drape under way: sew, weld, let gravity in, settle. Advances by steps, so that whoever runs it may
// watch, pause or stop between any two.

#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/collision/crossings.h"
#include "core/drape/checkpoint.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/drape/settle.h"
#include "core/drape/stop_reason.h"
#include "core/sewing/assembly.h"
#include "core/solver/cloth_solver.h"

namespace toile::drape {

class DrapeSession {
 public:
  /// Prepares a drape. `input` must outlive the session. `assembly` has passed run_preflight without an
  /// error: from a start without crossings none will come. With `dressed` (m, one a garment vertex, sewn ones
  /// together, certified) it begins there, with all seams shut. `ground` (m) is the height of a floor under
  /// all of it.
  static std::unique_ptr<DrapeSession> start(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                                             sewing::Assembly assembly,
                                             const std::optional<std::vector<Vec3>>& dressed = std::nullopt,
                                             std::optional<double> ground = std::nullopt);

  /// One substep. REQUIRES !done().
  void step();
  /// Begins once more, on the body, as with `dressed` and `ground` of start(): steps and time count on.
  void begin_anew(const std::vector<Vec3>& dressed, std::optional<double> ground);

  /// All that the session must remember, for restore().
  SessionState state() const;
  /// Goes on where another session stood that was started from the same input. Error: checkpoint.damaged when
  /// the state does not fit this garment.
  Status restore(SessionState state);

  bool dressed() const { return dressed_; }  ///< it began on the body
  bool lost_seams() const;                   ///< the threads of a seam have let go
  bool done() const { return phase_ == Phase::kDone; }
  /// Why it ended; nothing until done(). Never Stop::kCancelled: that is for whoever runs the session to say.
  const std::optional<StopReason>& stop_reason() const { return stop_reason_; }

  int steps() const { return steps_; }
  double time() const { return time_; }                      ///< s, simulated
  bool just_welded() const { return welded_at_ == steps_; }  ///< in the last step
  Progress progress() const;
  const sewing::GarmentMesh& garment() const { return assembly_.garment; }
  double rms_speed() const { return watch_.rms_speed(); }
  double max_speed() const { return watch_.max_speed(); }
  double seam_gap() const;  ///< m, the largest
  std::vector<OpenSeam> open_seams() const;
  std::vector<HoldFigures> holds() const;  ///< one for each attachment

  std::vector<Vec3> positions() const;  ///< m, of the garment's vertices
  const std::vector<Vec3>& start_positions() const { return assembly_.positions; }
  CrossingCount count_crossings();  ///< exact, now

 private:
  using Phase = DrapePhase;

  DrapeSession(const DrapeInput& input, const mesh::PanelMeshes& meshes, sewing::Assembly assembly,
               std::optional<double> ground);
  void add_ground(double height);
  void begin_dressed(const std::vector<Vec3>& positions);
  double sew_time() const;
  void build_solver(solver::ClothModel model, std::vector<Vec3> positions, std::vector<Vec3> velocities);
  solver::ClothModel model_of(std::span<const Index> vertex_of, Index vertex_count) const;
  std::vector<solver::constraints::Stitch> stitches_now() const;
  std::vector<solver::constraints::HeldVertex> held_now() const;
  solver::ClothFeatures features_now() const;
  solver::StepForces forces_now() const;
  void sew_or_weld();
  void weld();
  void weld_what_closed();
  void let_go_of_lost_seams();
  std::vector<double> pair_gaps() const;
  void settle_or_stop();
  double time_of_full_gravity() const;
  bool dynamic() const;
  solver::constraints::OpenTie open_button() const;
  bool lies_still() const;
  bool nothing_closes() const;
  Stop stop_at_rest() const;
  double gap_at(Stop kind) const;
  void end(Stop kind);
  std::string name_of_widest_seam() const;

  const DrapeInput& input_;
  sewing::Assembly assembly_;
  collision::CrossingCounter crossings_;  ///< of the garment's own vertices
  std::vector<Vec2> warps_;
  std::vector<collision::Obstacle> obstacles_;
  std::vector<collision::CrossingBody> crossing_bodies_;
  std::unique_ptr<solver::ClothSolver> solver_;
  std::vector<Index> vertex_of_;
  std::vector<bool> lost_;              ///< seams that did not close: their threads have let go
  std::vector<bool> released_;          ///< attachments
  std::vector<double> off_at_release_;  ///< m, of each

  Phase phase_ = Phase::kSew;
  bool dressed_ = false, grounded_ = false;
  std::optional<StopReason> stop_reason_;  ///< while phase_ is kDone
  SettleWatch watch_;
  int steps_ = 0;
  double time_ = 0, begun_ = 0, phase_start_ = 0, last_weld_ = 0;
  int welded_at_ = -1;  ///< step of the last weld; not kept by checkpoints, which lie between steps
  int slackened_ = 0;   ///< how often threads were let out again
};

/// Simulated s that a drape takes at least, if it runs until it is at rest.
double shortest_drape(const DrapeInput& input);
/// Simulated s after which a garment is sewn, but for seams that do not close.
double longest_sewing(const DrapeSettings& settings);

}  // namespace toile::drape
