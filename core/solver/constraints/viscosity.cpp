#include "core/solver/constraints/viscosity.h"

namespace toile::solver::constraints {

void even_velocities(std::span<const Tri> triangles, std::span<const double> mass, double share,
                     std::span<Vec3> velocity) {
  for (const Tri& t : triangles) {
    const double m0 = mass[t[0]], m1 = mass[t[1]], m2 = mass[t[2]];
    const Vec3 common =
        (velocity[t[0]] * m0 + velocity[t[1]] * m1 + velocity[t[2]] * m2) * (share / (m0 + m1 + m2));
    for (const Index v : t) velocity[v] = velocity[v] * (1 - share) + common;
  }
}

}  // namespace toile::solver::constraints
