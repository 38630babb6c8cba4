#pragma once
// What lies over a wearer's shoulders does not slide outwards past where it was meant to lie, and is free in
// all else, as if somebody kept a hand there. Coulomb friction on hard bodies lets straps slide off slopes
// that they stay on in use, where soft skin gives way under them.

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::solver::constraints {

/// How fast cloth is brought back, m/s; contact decides whether it gets there. Slow: what a hand moves keeps
/// its speed, and one that comes and goes with `is_needed` would stir the garment for ever.
inline constexpr double kHandSpeed = 0.05;

/// One shoulder. Lengths in m.
struct ShoulderHold {
  struct Held {
    Index v = 0;       ///< of the solver
    double aside = 0;  ///< from the middle, at most
  };
  double middle = 0;  ///< x of the wearer's mid-plane
  Vec3 neck, ridge;   ///< where the shoulder's slope begins; from there to its outer end
  /// The region in which it holds: shares of the ridge, how far to front and back of it, how far beneath.
  double share_from = 0, share_to = 1, across = 0, below = 0;
  /// Share of the ridge within which cloth is at the neck: such a garment cannot slide off, and is free.
  double share_at_neck = 0;
  std::vector<Held> held;
};

/// Whether it holds what is at `p`, once it holds.
bool holds_at(const ShoulderHold& hold, Vec3 p);
/// Whether it holds: no cloth is at the neck.
bool is_needed(const ShoulderHold& hold, std::span<const Vec3> x);

/// One pass: takes back what slid out since `before`, where the step began, however hard it is pulled, and
/// brings back by no more than `kHandSpeed`. `w` is 1/kg, 0 for what is pinned; `h` the step, s.
void solve_shoulder_holds(std::span<const ShoulderHold> holds, std::span<const double> w, double h,
                          std::span<const Vec3> before, std::span<Vec3> x);

/// Whether anything leans on it, so that it would slide without.
bool bears(const ShoulderHold& hold, std::span<const Vec3> x);

}  // namespace toile::solver::constraints
