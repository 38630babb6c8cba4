#pragma once
// Hands on cloth that drapes: what they hold, and the log of all that they did. A pull is a leash that is
// weak (it gives way before the cloth does) and whose goal follows the hand at a walking pace, so that a
// pointer that jumps throws nothing. A pin is a strong one that stays. Both hold a patch as wide as
// fingertips, since a point would be drawn out to a thorn. Contact is stronger than both.

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/drape/touch.h"
#include "core/sewing/garment_mesh.h"
#include "core/solver/constraints/leash.h"

namespace toile::drape {

class Hands {
 public:
  /// At once; and touches of a drape, after which it takes no more.
  static constexpr std::size_t kMostPulls = 16, kMostPins = 100, kMostTouches = 100'000;

  /// Does what a touch says, at cloth whose garment vertices are at `x` (m), and logs it. Errors, after which
  /// nothing has changed: live.point (no point of this cloth), live.target (no place, or beyond 100 m),
  /// live.too_many (hands or pins), live.no_pin (there is none of that number), live.full. Letting go of
  /// nothing is none, and is not logged.
  Status take(Touch touch, const sewing::GarmentMesh& garment, std::span<const Vec3> x);
  /// A step of `h` (s) begins: goals follow their hands. Whether any did.
  bool follow(double h);

  bool pulling() const { return !state_.pulls.empty(); }
  bool idle() const { return state_.pulls.empty() && state_.pins.empty(); }
  bool untouched() const { return state_.log.empty(); }

  /// What they do to a cloth of such a `weight` (N), whose solver's vertex of garment vertex i is
  /// `vertex_of[i]`: the pulls, then the pins.
  std::vector<solver::constraints::Leash> leashes(const sewing::GarmentMesh& garment,
                                                  std::span<const Index> vertex_of, double weight) const;
  /// Draws leashes that were made of these grips to where their goals are now.
  void aim(std::vector<solver::constraints::Leash>& leashes) const;

  const HandsState& state() const { return state_; }
  void restore(HandsState state) { state_ = std::move(state); }

 private:
  Status check(const Touch& touch, const sewing::GarmentMesh& garment) const;
  void log(const Touch& touch);

  HandsState state_;
};

/// Whether a state can be of hands on such a garment.
bool is_sound(const HandsState& state, const sewing::GarmentMesh& garment);

/// Whether those touches can have been made at a garment of so many triangles: of a log that comes from
/// outside. Errors: those of Hands::take, live.order (steps that go back).
Status check_touches(const std::vector<Touch>& touches, const sewing::GarmentMesh& garment);

}  // namespace toile::drape
