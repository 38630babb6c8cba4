#include "core/solver/constraints/leash.h"

#include <algorithm>

namespace toile::solver::constraints {

Vec3 held_by(const Leash& leash, std::span<const Vec3> x) {
  Vec3 mean;
  for (std::size_t k = 0; k < leash.patch.size(); ++k) mean += x[leash.patch[k]] * leash.share[k];
  return mean;
}

void solve_leashes(std::span<const Leash> leashes, std::span<const double> w, double h, std::span<Vec3> x) {
  for (const Leash& leash : leashes) {
    const Vec3 d = leash.target - held_by(leash, x);
    const double l = length(d);
    double mobility = 0;
    for (std::size_t k = 0; k < leash.patch.size(); ++k)
      mobility += w[leash.patch[k]] * leash.share[k] * leash.share[k];
    if (l <= 0 || mobility <= 0) continue;
    const double impulse = std::min(l / (mobility + 1 / (leash.stiffness * h * h)), leash.most_force * h * h);
    const Vec3 pull = d * (impulse / l);
    for (std::size_t k = 0; k < leash.patch.size(); ++k)
      x[leash.patch[k]] += pull * (leash.share[k] * w[leash.patch[k]]);
  }
}

}  // namespace toile::solver::constraints
