#pragma once
// What lies over a wearer's shoulders does not slide outwards past where it was meant to lie, and is free in
// all else, as if somebody kept a hand there. Coulomb friction on hard bodies lets straps slide off slopes
// that they stay on in use, where soft skin gives way under them.

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::solver::constraints {

/// How fast cloth is brought back, m/s; contact decides whether it gets there. Slower than 0.2, wide necks
/// fall off before; faster than 2, a hand that comes and goes with `is_needed` stirs narrow straps for ever.
inline constexpr double kHandSpeed = 0.5;

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

/// How far the hand brought a vertex back in a step, m along x.
struct BroughtBack {
  Index v = 0;
  double dx = 0;
};

/// One pass: stops what slid out since `before`, where the step began, however hard it is pulled, and brings
/// back what is out still. `w` is 1/kg, 0 for what is pinned; `h` the step, s. Adds to `brought`.
void solve_shoulder_holds(std::span<const ShoulderHold> holds, std::span<const double> w, double h,
                          std::span<const Vec3> before, std::span<Vec3> x, std::vector<BroughtBack>& brought);

/// Takes from the velocities (m/s) what the hand brought: it lays cloth back and does not throw it.
void let_lie(std::span<const BroughtBack> brought, double h, std::span<Vec3> velocity);

/// Whether anything leans on it, so that it would slide without.
bool bears(const ShoulderHold& hold, std::span<const Vec3> x);

}  // namespace toile::solver::constraints
