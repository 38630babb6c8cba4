#pragma once
// Tethers: points of the cloth that are led to a place or to a line in space, and kept there. Along a line
// they are free to slide. Contact is stronger: a tether that a body is in the way of waits.

#include <memory>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/sewing/notion_places.h"

namespace toile::solver::constraints {

/// What is nearer than this to where it may be is held with all force; the rest comes at kTetherSpeed.
inline constexpr double kTetherClosed = 2e-3;  // m
inline constexpr double kTetherSpeed = 3;      // m/s

struct Tether {
  sewing::ClothPoint at;                          ///< in vertices of the solver
  std::shared_ptr<const std::vector<Vec3>> goal;  ///< m; a point, or the corners of a closed line
  double start_length = 0;                        ///< m, from the goal before it is drawn in
};

/// One pass: every point is at most as far from its goal as it may be when `open` of the way (1 at the start,
/// 0 when closed) is left.
void solve_tethers(std::span<const Tether> tethers, double open, std::span<const double> w, double h,
                   std::span<Vec3> x);

/// m from its goal.
double length_of(const Tether& tether, std::span<const Vec3> x);

}  // namespace toile::solver::constraints
