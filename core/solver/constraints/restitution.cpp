#include "core/solver/constraints/restitution.h"

namespace toile::solver::constraints {

namespace {

/// Of a contact's point, along its normal.
double along_normal(const collision::Contact& c, std::span<const Vec3> vectors) {
  Vec3 sum;
  for (int i = 0; i < c.count; ++i) sum += vectors[c.v[i]] * c.w[i];
  return dot(c.n, sum);
}

}  // namespace

std::vector<Impact> find_impacts(std::span<const collision::Contact> contacts, double factor,
                                 std::span<const Vec3> proposed, std::span<const Vec3> velocities) {
  std::vector<Impact> impacts;
  for (const collision::Contact& c : contacts) {
    const double restitution = factor * c.restitution;
    if (restitution <= 0 || along_normal(c, proposed) - c.c >= c.rest) continue;
    const double speed = -along_normal(c, velocities);
    if (speed > kLeastImpact) impacts.push_back({&c, restitution * speed});
  }
  return impacts;
}

void give_back(std::span<const Impact> impacts, std::span<const double> inverse_mass,
               std::span<Vec3> velocities) {
  for (const Impact& impact : impacts) {
    const collision::Contact& c = *impact.contact;
    double mass = 0;
    for (int i = 0; i < c.count; ++i) mass += inverse_mass[c.v[i]] * c.w[i] * c.w[i];
    const double lacking = impact.away - along_normal(c, velocities);
    if (mass <= 0 || lacking <= 0) continue;
    for (int i = 0; i < c.count; ++i) {
      velocities[c.v[i]] += c.n * (lacking * inverse_mass[c.v[i]] * c.w[i] / mass);
    }
  }
}

}  // namespace toile::solver::constraints
