#pragma once
// Cloth that strikes something hard leaves it again: Newton's law of restitution, after the contacts have
// stopped the cloth (as in Müller et al., "Detailed Rigid Body Simulation with Extended Position Based
// Dynamics", 2020).

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/collision/contacts.h"

namespace toile::solver::constraints {

/// A slower impact is none, m/s. Gravity adds 3 mm/s in a step, and cloth at rest must not hop.
inline constexpr double kLeastImpact = 0.05;

/// A contact at which cloth struck in this step, and the speed at which it is to leave, m/s.
struct Impact {
  const collision::Contact* contact = nullptr;
  double away = 0;
};

/// The contacts that the proposed positions run into at speed. `velocities` are those with which the step
/// began: what seams and stretched cloth press against a skin is no impact. `factor` scales the restitution.
std::vector<Impact> find_impacts(std::span<const collision::Contact> contacts, double factor,
                                 std::span<const Vec3> proposed, std::span<const Vec3> velocities);

/// Gives the cloth of each impact its speed away from the skin, where it has less by now.
void give_back(std::span<const Impact> impacts, std::span<const double> inverse_mass,
               std::span<Vec3> velocities);

}  // namespace toile::solver::constraints
