#pragma once
// A drape under way by the method of Kim and Park 2003 (core/paper), from the same input as by our own
// engine: the same meshes, seams, bodies and attachments, and judged by the same counts. Seams close in
// sew_time without gravity, by their midpoints; then gravity is there at once. Its own are the time step, the
// damping, the passes and the reflection. Buttons, elastic, creases, cushions and air are none of its.

#include <memory>
#include <optional>
#include <vector>

#include "core/drape/garment_crossings.h"
#include "core/drape/session.h"
#include "core/drape/settle.h"
#include "core/mesh/panel_mesh.h"
#include "core/paper/paper_cloth.h"

namespace toile::drape {

class PaperSession : public Session {
 public:
  /// As DrapeSession::start().
  static std::unique_ptr<PaperSession> start(const DrapeInput& input, const mesh::PanelMeshes& meshes,
                                             sewing::Assembly assembly,
                                             const std::optional<std::vector<Vec3>>& dressed,
                                             std::optional<double> ground);

  void step(Crew& crew) override;
  /// Never asked for: may_begin_anew() says no. What the method makes of a start is its result.
  void begin_anew(const std::vector<Vec3>& dressed, std::optional<double> ground) override;
  bool may_begin_anew() const override { return false; }

  SessionState state() const override;
  Status restore(SessionState state) override;

  Began began() const override { return dressed_ ? Began::kDressed : Began::kPlaced; }
  bool lost_seams() const override { return false; }
  const std::optional<StopReason>& stop_reason() const override { return stop_reason_; }

  int steps() const override { return steps_; }
  double time() const override { return steps_ * input_.settings.paper.time_step; }
  bool just_welded() const override { return false; }
  Progress progress() const override;
  const sewing::GarmentMesh& garment() const override { return assembly_.garment; }
  double rms_speed() const override { return watch_.rms_speed(); }
  double max_speed() const override { return watch_.max_speed(); }
  double seam_gap() const override;
  std::vector<OpenSeam> open_seams() const override;
  std::vector<std::vector<Vec3>> moved_bodies() const override {
    return std::vector<std::vector<Vec3>>(input_.bodies.size());
  }
  MotionFigures motion() const override { return {}; }
  std::vector<HoldFigures> holds() const override;
  std::array<bool, 2> held_on_shoulders() const override { return {}; }

  std::vector<Vec3> positions() const override { return cloth_.positions(); }
  const std::vector<Vec3>& start_positions() const override { return assembly_.positions; }
  CrossingCount count_crossings(Crew& crew) override { return crossings_.count(cloth_.positions(), crew); }

 private:
  using Phase = DrapePhase;

  PaperSession(const DrapeInput& input, const mesh::PanelMeshes& meshes, sewing::Assembly assembly,
               const std::optional<std::vector<Vec3>>& dressed, std::optional<double> ground);
  void attach();
  double rate() const;
  double since() const { return time() - phase_start_; }
  void sew_on();
  void settle_or_stop();
  bool release_in_time();
  void end(Stop kind);

  const DrapeInput& input_;
  sewing::Assembly assembly_;
  GarmentCrossings crossings_;
  paper::PaperCloth cloth_;
  std::vector<bool> released_;          ///< attachments
  std::vector<double> off_at_release_;  ///< m, of each

  Phase phase_ = Phase::kSew;
  bool dressed_ = false;
  std::optional<StopReason> stop_reason_;  ///< while phase_ is kDone
  SettleWatch watch_;
  int steps_ = 0;
  double phase_start_ = 0;  ///< s
};

/// What of the input the method leaves out, in words; empty when it takes all.
std::string left_out_by_paper(const DrapeInput& input);

}  // namespace toile::drape
