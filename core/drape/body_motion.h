#pragma once
// Bodies that change their shape or pose while cloth hangs on them: children grow, arms rise. A body moves
// between steps, by less than half of what lies between it and the cloth (core/collision/obstacle_way.h), and
// contact then pushes the cloth along. Where cloth cannot give way, all bodies wait; where waiting does not
// help, they stay, and it is told what was too tight.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/body/body.h"
#include "core/collision/obstacle.h"
#include "core/collision/obstacle_way.h"
#include "core/solver/cloth_model.h"
#include "core/solver/constraints/membrane.h"

namespace toile::drape {

/// What a BodyMotion remembers.
struct MotionState {
  enum class Phase : std::uint8_t { kToCome, kGoing, kOver };
  Phase phase = Phase::kToCome;
  double played = 0, before = 0;  ///< s of the motion, until now and until before the newest move
  double waited = 0;              ///< s, for cloth that could not give way
  double marked = 0;              ///< s of the motion at the newest mark
  double since = 0, hoped = 0;    ///< s, simulated since that, and of the motion that could have been played
  int steps = 0;                  ///< until the next move
  int pace = 1;                   ///< steps that the newest move was for
  int over = 0;                   ///< triangles out of shape when it began
  Index tight = kNone;            ///< vertex of the cloth where it could not give way last
};

class BodyMotion {
 public:
  BodyMotion(std::span<const body::Body> bodies, double time_step);

  bool is_to_come() const { return !times_.empty() && state_.phase == MotionState::Phase::kToCome; }
  bool has_begun() const { return state_.phase != MotionState::Phase::kToCome; }
  bool is_going() const { return state_.phase == MotionState::Phase::kGoing; }
  /// It has been played to its end, or nobody moves.
  bool is_whole() const { return times_.empty() || state_.played >= times_.back(); }
  double share() const { return times_.empty() ? 1 : state_.played / times_.back(); }

  /// `x` (m): where the cloth of `model` is, which the motion is going to move. REQUIRES is_to_come().
  void begin(const solver::ClothModel& model, std::span<const Vec3> x);
  /// Before a step: moves the obstacles, one a body, when it is time. True when they moved, or stopped.
  /// REQUIRES is_going().
  bool move(std::span<const Vec3> x, std::span<collision::Obstacle> obstacles);

  /// m, of a body as it is now.
  std::vector<Vec3> vertices(std::size_t body) const { return vertices_at(body, state_.played); }
  bool moves(std::size_t body) const { return !bodies_[body].motion.empty(); }
  /// m, that a body still had to go outwards near a place, where it was stopped.
  double way_left_near(Vec3 place) const;

  const MotionState& state() const { return state_; }
  /// Goes on with the cloth of `model`; puts the obstacles where they were.
  void restore(MotionState state, const solver::ClothModel& model, std::span<collision::Obstacle> obstacles);
  /// Back to the start: the obstacles, too.
  void reset(std::span<collision::Obstacle> obstacles);

 private:
  std::vector<Vec3> vertices_at(std::size_t body, double time) const;
  void take(const solver::ClothModel& model);
  int count_out_of_shape(std::span<const Vec3> x, Index& worst) const;
  double free_share(std::span<const Vec3> x, std::span<const collision::Obstacle> obstacles, double to);
  void place(std::span<collision::Obstacle> obstacles) const;
  bool is_stuck();

  std::span<const body::Body> bodies_;
  double h_;
  double most_move_;            ///< m, of a vertex at once
  std::vector<double> times_;   ///< s, of all bodies' keyframes
  std::vector<double> speeds_;  ///< m/s, the highest until each of these
  std::vector<solver::constraints::MembraneTriangle> triangles_;
  std::optional<collision::ObstacleWays> ways_;
  std::vector<collision::FeatureBoxes> boxes_;  ///< of each body's way
  MotionState state_;
};

}  // namespace toile::drape
