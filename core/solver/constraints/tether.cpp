#include "core/solver/constraints/tether.h"

#include <algorithm>

#include "core/sewing/attached_places.h"

namespace toile::solver::constraints {

void solve_tethers(std::span<const Tether> tethers, double open, std::span<const double> w, double h,
                   std::span<Vec3> x) {
  for (const Tether& tether : tethers) {
    const Vec3 p = sewing::position_of(tether.at, x);
    const Vec3 d = sewing::nearest_on_goal(*tether.goal, p) - p;
    const double l = length(d), excess = l - tether.start_length * open;
    double mobility = 0;
    for (int i = 0; i < 3; ++i) mobility += w[tether.at.v[i]] * tether.at.share[i] * tether.at.share[i];
    if (excess <= 0 || mobility <= 0) continue;
    const double way = excess > kTetherClosed ? std::min(excess, kTetherSpeed * h) : excess;
    const Vec3 pull = d * (way / (l * mobility));
    for (int i = 0; i < 3; ++i) x[tether.at.v[i]] += pull * (tether.at.share[i] * w[tether.at.v[i]]);
  }
}

double length_of(const Tether& tether, std::span<const Vec3> x) {
  const Vec3 p = sewing::position_of(tether.at, x);
  return length(sewing::nearest_on_goal(*tether.goal, p) - p);
}

}  // namespace toile::solver::constraints
