#pragma once
// A drape under way by our own engine: sew, weld, let gravity in, settle.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/body_motion.h"
#include "core/drape/checkpoint.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/drape/garment_crossings.h"
#include "core/drape/hands.h"
#include "core/drape/rest_probe.h"
#include "core/drape/session.h"
#include "core/drape/settle.h"
#include "core/drape/stop_reason.h"
#include "core/drape/weld.h"
#include "core/dressing/person.h"
#include "core/sewing/assembly.h"
#include "core/solver/cloth_solver.h"

namespace toile::drape {

class DrapeSession : public Session {
 public:
  /// Prepares a drape. `input` must outlive the session. `assembly` has passed run_preflight without an
  /// error: from a start without crossings none will come. With `dressed` (m, one a garment vertex, sewn ones
  /// together, certified) it begins there, with all seams shut. `ground` (m) is the height of a floor under
  /// all of it.
  static std::unique_ptr<DrapeSession> start(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                                             sewing::Assembly assembly,
                                             const std::optional<std::vector<Vec3>>& dressed = std::nullopt,
                                             std::optional<double> ground = std::nullopt);

  /// Goes on with the cloth of `before` as it hung, cut to this garment; `wearer` is one of the bodies.
  /// Without an error it has begun there. Errors: those of warm::go_on_from; then nothing has changed.
  /// REQUIRES no step to have been made.
  Status go_on_from(const warm::HungGarment& before, const mesh::PanelMeshes& meshes,
                    const std::optional<dressing::Person>& wearer);

  void step(Crew& crew) override;
  void begin_anew(const std::vector<Vec3>& dressed, std::optional<double> ground) override;
  /// Not once hands have been on it: where it hangs then is what they wanted.
  bool may_begin_anew() const override { return hands_.untouched(); }

  Status touch(const Touch& touch) override;
  const HandsState& hands() const override { return hands_.state(); }

  SessionState state() const override;
  Status restore(SessionState state) override;

  Began began() const override { return began_; }
  bool lost_seams() const override;
  const std::optional<StopReason>& stop_reason() const override { return stop_reason_; }

  int steps() const override { return steps_; }
  double time() const override { return time_; }
  bool just_welded() const override { return welded_at_ == steps_; }
  Progress progress() const override;
  const sewing::GarmentMesh& garment() const override { return assembly_.garment; }
  double rms_speed() const override { return watch_.rms_speed(); }
  double max_speed() const override { return watch_.max_speed(); }
  double seam_gap() const override;
  std::vector<OpenSeam> open_seams() const override;
  std::vector<std::vector<Vec3>> moved_bodies() const override;
  MotionFigures motion() const override;
  std::vector<HoldFigures> holds() const override;
  std::array<bool, 2> held_on_shoulders() const override;

  std::vector<Vec3> positions() const override;
  const std::vector<Vec3>& start_positions() const override { return assembly_.positions; }
  CrossingCount count_crossings(Crew& crew) override;

 private:
  using Phase = DrapePhase;

  DrapeSession(const DrapeInput& input, const mesh::PanelMeshes& meshes, sewing::Assembly assembly,
               std::optional<double> ground);
  void put_ground(double height);
  void begin_dressed(const std::vector<Vec3>& positions);
  double sew_time() const;
  double share_out_of_shape() const;
  void come_back_to_shape();
  void give_way(const solver::StepForces& forces);
  void build_solver(solver::ClothModel model, std::vector<Vec3> positions, std::vector<Vec3> velocities);
  solver::ClothModel model_of(std::span<const Index> vertex_of, Index vertex_count) const;
  std::vector<solver::constraints::Stitch> stitches_now() const;
  std::vector<solver::constraints::HeldVertex> held_now() const;
  solver::ClothFeatures features_now() const;
  solver::StepForces forces_now() const;
  void sew_or_weld();
  Weld weld_now() const;
  void join(Weld weld);
  void weld_what_closed();
  void let_go_of_lost_seams();
  std::vector<double> pair_gaps() const;
  void settle_or_stop();
  bool begins_to_move();
  void move_bodies();
  double time_of_full_gravity() const;
  bool dynamic() const;
  void let_go_of_timed_holds();
  void lead_by_hands();
  std::vector<solver::constraints::Leash> leashes_now() const;
  bool waits_for_hands() const;
  solver::constraints::OpenTie open_button() const;
  bool lies_still(double calm) const;
  void let_go();
  bool stays_when_let_go();
  bool is_let_go_first() const;
  bool nothing_closes() const;
  Stop stop_at_rest() const;
  double gap_at(Stop kind) const;
  void end(Stop kind);

  const DrapeInput& input_;
  sewing::Assembly assembly_;
  GarmentCrossings crossings_;
  std::vector<Vec2> warps_;
  std::vector<collision::Obstacle> obstacles_;
  std::unique_ptr<solver::ClothSolver> solver_;
  std::vector<Index> vertex_of_;
  std::vector<bool> lost_;              ///< seams that did not close: their threads have let go
  std::vector<bool> released_;          ///< attachments
  std::vector<double> off_at_release_;  ///< m, of each

  Phase phase_ = Phase::kSew;
  Began began_ = Began::kPlaced;
  bool grounded_ = false;
  std::optional<dressing::Person> wearer_;  ///< whose shoulders keep the garment until they move
  std::optional<StopReason> stop_reason_;   ///< while phase_ is kDone
  SettleWatch watch_;
  RestProbe probe_;
  BodyMotion motion_;
  Hands hands_;
  bool bodies_moved_ = false;  ///< since crossings were counted last
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
