#include "core/solver/constraints/contact_pass.h"

#include <algorithm>

namespace toile::solver::constraints {

namespace {

/// Weighted sum of a contact's vertices: a point for skin contact, the difference of two points for layers.
Vec3 point_of(const collision::Contact& c, std::span<const Vec3> x) {
  Vec3 p;
  for (int i = 0; i < c.count; ++i) p += x[c.v[i]] * c.w[i];
  return p;
}

}  // namespace

void solve_contacts(std::span<const collision::Contact> contacts, std::span<const Vec3> before,
                    std::span<const double> w, double friction, double h, std::span<Vec3> x,
                    std::span<Vec3> depenetration) {
  for (const collision::Contact& c : contacts) {
    const Vec3 now = point_of(c, x);
    const double distance = dot(c.n, now) - c.c;
    if (distance >= c.rest) continue;
    double mass = 0;
    for (int i = 0; i < c.count; ++i) mass += w[c.v[i]] * c.w[i] * c.w[i];
    if (mass <= 0) continue;

    const Vec3 start = point_of(c, before);
    const double floor = std::min(c.rest, dot(c.n, start) - c.c);  // where it rested is no approach
    const double approach = std::max(0.0, floor - distance);
    const double raise =
        std::clamp(kDepenetrationShare * c.rest - std::max(distance, floor), 0.0, kPushOutSpeed * h);

    const Vec3 moved = now - start - c.carried * h, slip = moved - c.n * dot(c.n, moved);
    const double slipped = length(slip), hold = friction * c.friction * approach;
    const Vec3 rub = slipped > hold && slipped > 0 ? slip * (hold / slipped) : slip;
    const Vec3 stop = c.n * approach - (hold > 0 ? rub : Vec3{}), push = c.n * raise;
    for (int i = 0; i < c.count; ++i) {
      const double share = w[c.v[i]] * c.w[i] / mass;
      x[c.v[i]] += (stop + push) * share;
      depenetration[c.v[i]] += push * share;
    }
  }
}

}  // namespace toile::solver::constraints
