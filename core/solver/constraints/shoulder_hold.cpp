#include "core/solver/constraints/shoulder_hold.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace toile::solver::constraints {

namespace {
/// What is nearer than this to as far as it may go leans on the hand, m: a step's slide is far less.
constexpr double kLeaning = 1e-4;

/// Of the way along the ridge; nothing where the place is not over the shoulder.
std::optional<double> share_at(const ShoulderHold& hold, Vec3 p) {
  if (hold.ridge.x == 0) return std::nullopt;
  const double share = (p.x - hold.neck.x) / hold.ridge.x;
  const Vec3 off = p - (hold.neck + hold.ridge * share);
  if (share < hold.share_from || share > hold.share_to) return std::nullopt;
  return off.y > -hold.below && std::abs(off.z) < hold.across ? std::optional(share) : std::nullopt;
}

}  // namespace

bool holds_at(const ShoulderHold& hold, Vec3 p) { return share_at(hold, p).has_value(); }

bool is_needed(const ShoulderHold& hold, std::span<const Vec3> x) {
  return std::none_of(hold.held.begin(), hold.held.end(), [&](const ShoulderHold::Held& held) {
    const std::optional<double> share = share_at(hold, x[held.v]);
    return share && *share < hold.share_at_neck;
  });
}

void solve_shoulder_holds(std::span<const ShoulderHold> holds, std::span<const double> w, double h,
                          std::span<const Vec3> before, std::span<Vec3> x,
                          std::vector<BroughtBack>& brought) {
  for (const ShoulderHold& hold : holds) {
    if (!is_needed(hold, x)) continue;
    for (const ShoulderHold::Held& held : hold.held) {
      Vec3& p = x[held.v];
      const double aside = std::abs(p.x - hold.middle), out = aside - held.aside;
      if (out <= 0 || w[held.v] == 0 || !holds_at(hold, p)) continue;
      const double slid = std::max(0.0, aside - std::abs(before[held.v].x - hold.middle));
      const double stopped = std::min(out, slid), back = std::min(out - stopped, kHandSpeed * h);
      const double inwards = p.x > hold.middle ? -1 : 1;
      p.x += inwards * (stopped + back);
      if (back > 0) brought.push_back({held.v, inwards * back});
    }
  }
}

void let_lie(std::span<const BroughtBack> brought, double h, std::span<Vec3> velocity) {
  for (const BroughtBack& b : brought) {
    double& v = velocity[b.v].x;
    const double most = b.dx / h;  // contact may have kept it from going all the way
    v -= most > 0 ? std::clamp(v, 0.0, most) : std::clamp(v, most, 0.0);
  }
}

bool bears(const ShoulderHold& hold, std::span<const Vec3> x) {
  return is_needed(hold, x) &&
         std::any_of(hold.held.begin(), hold.held.end(), [&](const ShoulderHold::Held& held) {
           const Vec3 p = x[held.v];
           return std::abs(p.x - hold.middle) - held.aside > -kLeaning && holds_at(hold, p);
         });
}

}  // namespace toile::solver::constraints
