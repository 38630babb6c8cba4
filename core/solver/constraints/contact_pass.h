#pragma once
// Pushes layers and skin apart to their rest distance, with Coulomb friction. Comfort, not safety: that cloth
// never goes through is the bounds' part (core/collision/contacts.h).

#include <span>

#include "core/base/types.h"
#include "core/collision/contacts.h"

namespace toile::solver::constraints {

/// Speed at which cloth that is too near is pushed out, m/s. This depenetration moves positions only and
/// leaves velocities alone, else contacts would jitter.
inline constexpr double kPushOutSpeed = 0.3;

/// Share of the rest distance up to which cloth is pushed out. Between there and the rest distance it is only
/// stopped: depenetration raises cloth against its weight for nothing, and where resting cloth was raised
/// again and again it shivered for ever, by 30 mm/s on a disc (0.06 mm/s with this).
inline constexpr double kDepenetrationShare = 0.75;

/// One pass over the contacts. `before` are the positions at the substep's start; `depenetration` (one a
/// vertex, m) collects what must not count as velocity. `friction` scales the coefficients (0 while sewing).
void solve_contacts(std::span<const collision::Contact> contacts, std::span<const Vec3> before,
                    std::span<const double> w, double friction, double h, std::span<Vec3> x,
                    std::span<Vec3> depenetration);

}  // namespace toile::solver::constraints
