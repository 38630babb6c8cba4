#include "core/solver/constraints/shoulder_hold.h"

#include <algorithm>
#include <cmath>

namespace toile::solver::constraints {

namespace {
/// What is nearer than this to as far as it may go leans on the hand, m: a step's slide is far less.
constexpr double kLeaning = 1e-4;
}  // namespace

bool holds_at(const ShoulderHold& hold, Vec3 p) {
  if (hold.ridge.x == 0) return false;
  const double share = (p.x - hold.neck.x) / hold.ridge.x;
  if (share < hold.share_from || share > hold.share_to) return false;
  const Vec3 off = p - (hold.neck + hold.ridge * share);
  return off.y > -hold.below && std::abs(off.z) < hold.across;
}

void solve_shoulder_holds(std::span<const ShoulderHold> holds, std::span<const double> w, double h,
                          std::span<Vec3> x) {
  for (const ShoulderHold& hold : holds) {
    for (const ShoulderHold::Held& held : hold.held) {
      Vec3& p = x[held.v];
      const double out = std::abs(p.x - hold.middle) - held.aside;
      if (out <= 0 || w[held.v] == 0 || !holds_at(hold, p)) continue;
      p.x += std::copysign(std::min(out, kHandSpeed * h), hold.middle - p.x);
    }
  }
}

bool bears(const ShoulderHold& hold, std::span<const Vec3> x) {
  return std::any_of(hold.held.begin(), hold.held.end(), [&](const ShoulderHold::Held& held) {
    const Vec3 p = x[held.v];
    return std::abs(p.x - hold.middle) - held.aside > -kLeaning && holds_at(hold, p);
  });
}

}  // namespace toile::solver::constraints
