#include "core/solver/constraints/leash.h"

#include <algorithm>

#include "core/sewing/attached_places.h"

namespace toile {

void solve_leashes(std::span<const Leash> leashes, double open, std::span<const double> w, double h,
                   std::span<Vec3> x) {
  for (const Leash& leash : leashes) {
    const Vec3 p = position_of(leash.at, x);
    const Vec3 d = nearest_on_goal(*leash.goal, p) - p;
    const double l = length(d), excess = l - leash.start_length * open;
    double mobility = 0;
    for (int i = 0; i < 3; ++i) mobility += w[leash.at.v[i]] * leash.at.share[i] * leash.at.share[i];
    if (excess <= 0 || mobility <= 0) continue;
    const double way = excess > kLeashClosed ? std::min(excess, kLeashSpeed * h) : excess;
    const Vec3 pull = d * (way / (l * mobility));
    for (int i = 0; i < 3; ++i) x[leash.at.v[i]] += pull * (leash.at.share[i] * w[leash.at.v[i]]);
  }
}

double length_of(const Leash& leash, std::span<const Vec3> x) {
  const Vec3 p = position_of(leash.at, x);
  return length(nearest_on_goal(*leash.goal, p) - p);
}

}  // namespace toile
