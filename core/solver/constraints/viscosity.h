#pragma once
// Inner friction of cloth: the corners of a triangle take up their common velocity, so that what shivers
// between neighbours dies down while wide folds swing on. It conserves momentum. For drapes, where only the
// end matters; in true motion the cloth has none.

#include <span>

#include "core/base/types.h"

namespace toile::solver::constraints {

/// Steps from one evening of velocities to the next: seldom, since it takes as long as a sweep of bending.
inline constexpr int kViscousInterval = 8;

/// The share of its differences that a triangle loses in the step of this number; 0 in most steps. `rate` in
/// 1/s, `h` the step in s.
constexpr double viscous_share(double rate, double h, long step) {
  const double way = rate * h * kViscousInterval;
  return step % kViscousInterval == 0 ? way / (1 + way) : 0;
}

/// Evens velocities (m/s) within each triangle by `share`, in the triangles' order; masses in kg, positive.
void even_velocities(std::span<const Tri> triangles, std::span<const double> mass, double share,
                     std::span<Vec3> velocity);

}  // namespace toile::solver::constraints
