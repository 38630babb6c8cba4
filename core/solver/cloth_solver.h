#pragma once
// Moves cloth: small steps of one iteration each (Macklin et al. 2019), every step inside the contact bounds.

#include <span>
#include <vector>

#include "core/collision/contact_finder.h"
#include "core/solver/cloth_features.h"
#include "core/solver/cloth_model.h"
#include "core/solver/constraints/hold.h"
#include "core/solver/constraints/stitch.h"
#include "core/solver/lanes/passes.h"

namespace toile {
class Crew;
}

namespace toile::solver {

/// What acts on the cloth during a step. May change from step to step.
struct StepForces {
  double gravity = 9.81;   ///< m/s², downwards
  bool learns = true;      ///< the membrane learns its preloads, where damping lets it
  double damping = 1;      ///< 1/s, of the velocity, as if in a thick medium; sets the pace of learning, too
  double viscosity = 0;    ///< share of velocity differences that triangles lose in this step, 0 to 1
  double friction = 1;     ///< factor on all coefficients
  double restitution = 1;  ///< likewise
  double stitch_length = 0;  ///< 1: stitches as long as at the start, 0: closed
  FeatureProgress features;
};

/// What a step saw. Numerical trouble is a flag here, never a NaN that leaves the step.
struct StepReport {
  int detections = 0;       ///< measurements of contact in this step, of all or of a part
  int measured = 0;         ///< vertices that were measured
  int bounded = 0;          ///< vertices that a bound stopped
  bool not_finite = false;  ///< a position left the numbers; the step was undone
};

/// What a solver must remember to go on as if it had never stopped. Everything else follows from what it is
/// made of.
struct SolverState {
  std::vector<Vec3> positions, velocities;  ///< m, m/s
  collision::Contacts contacts;             ///< bounds and lists; no centres before the first time
  std::vector<bool> stopped;                ///< vertices that a plane has stopped since they were measured
  std::vector<bool> stuck;                  ///< those that were stopped right after, too
  std::vector<Index> steps_near;            ///< since each was measured, in which it may have met a bound
  int hits = 0;                             ///< stops of others, summed over the steps since any was measured
  std::vector<Vec3> preloads;               ///< of the membrane, one a triangle
  constraints::LearningPace pace;           ///< of those
};

class ClothSolver {
 public:
  /// `obstacles` must outlive the solver. Positions in metres; velocities start at zero. The order in which
  /// contacts are met follows from where the vertices stand in `layout` (m; `positions` when it is empty):
  /// two solvers with the same layout and state make the same steps.
  ClothSolver(ClothModel model, std::vector<Vec3> positions, std::span<const collision::Obstacle> obstacles,
              double time_step, std::span<const Vec3> layout = {});

  /// The crew's size changes no byte of what comes out.
  StepReport step(const StepForces& forces, Crew& crew);
  StepReport step(const StepForces& forces);

  void set_stitches(std::vector<constraints::Stitch> stitches);
  /// Replaces all holds. Targets may lie away from where the vertices are; contact decides how fast they get
  /// there.
  void set_holds(std::vector<constraints::HeldVertex> held);
  void set_features(ClothFeatures features) { features_ = std::move(features); }
  /// Replaces those of the features, which stay otherwise.
  void set_leashes(std::vector<constraints::Leash> leashes) { features_.leashes = std::move(leashes); }
  void set_velocities(std::vector<Vec3> velocities) { velocity_ = std::move(velocities); }

  /// Obstacles were moved between two steps, without touching cloth: what was measured among them is void.
  void note_moved_obstacles() { detected_ = false; }

  /// What the membrane has learnt, one a triangle; another solver of the same triangles may go on with it.
  const std::vector<Vec3>& preloads() const { return membrane_.preloads(); }
  void set_preloads(std::vector<Vec3> preloads) { membrane_.set_preloads(std::move(preloads)); }

  /// Takes the shape as it is now for the one without stress, by preloads.
  void rest_here() { membrane_.rest_at(x_); }
  /// Keeps this share of all preloads.
  void keep_preloads(double share);
  /// Once nothing more is learnt of the preloads, cloth far beyond its limit gives way where it may
  /// (constraints::give_way).
  void give_way(const constraints::MayGive& may);

  SolverState state() const;
  /// REQUIRES a state of a solver with the same model; holds, stitches and features are not part of it.
  void restore(SolverState state);

  const ClothModel& model() const { return model_; }
  const std::vector<constraints::Stitch>& stitches() const { return stitches_; }
  const ClothFeatures& features() const { return features_; }
  const std::vector<Vec3>& positions() const { return x_; }
  const std::vector<Vec3>& velocities() const { return velocity_; }
  double time_step() const { return h_; }

 private:
  void predict(const StepForces& forces, Crew& crew);
  void measure_all(Crew& crew);
  void measure_again(Crew& crew);
  StepReport truncate(const StepForces& forces, Crew& crew);
  void push_apart(const StepForces& forces, Crew& crew);
  void note_who_went_far(Crew& crew);
  bool leaves_trust_region() const;
  void count_stops();
  bool wants_measuring(Index v) const;
  void note_who_is_stuck();
  void finish(const StepForces& forces, Crew& crew);

  ClothModel model_;
  std::span<const collision::Obstacle> obstacles_;
  double h_;
  lanes::MembranePass membrane_;
  lanes::BendPass bending_;
  std::vector<constraints::Stitch> stitches_;
  std::vector<constraints::StitchGroup> stitch_groups_;
  std::vector<constraints::HeldVertex> held_;
  ClothFeatures features_;
  std::vector<Vec3> feature_force_;
  std::vector<double> inverse_mass_;

  std::vector<Vec3> x_, before_, velocity_, depenetration_, proposal_;
  std::vector<constraints::BroughtBack> brought_;
  std::vector<lanes::LanePoint> points_;  ///< x_, while lanes work on it
  std::vector<double> speed_;             ///< m/s, of vertices to be measured
  std::vector<char> went_far_;            ///< marks of those
  std::vector<Index> far_;                ///< vertices that may have met a bound in this step
  std::vector<Index> moved_;              ///< that are measured again
  bool bouncy_ = false;                   ///< an obstacle throws cloth back
  collision::ContactFinder finder_;
  collision::Contacts contacts_;
  bool detected_ = false;
  std::vector<bool> stopped_;       ///< vertices that a plane has stopped since they were measured
  std::vector<bool> stuck_;         ///< those that were stopped right after, too
  std::vector<Index> steps_near_;   ///< since each was measured, in which it may have met a bound
  int hits_ = 0;                    ///< stops of others, summed over the steps since any was measured
  constraints::LearningPace pace_;  ///< at which the membrane learns its preloads
};

/// Thickness, friction and trust region sizes for a cloth: thickness at most 0.3 and trust regions at most
/// a quarter of the mean edge.
collision::ContactSettings contact_settings(const ClothModel& model);

}  // namespace toile::solver
