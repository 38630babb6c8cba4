#include "core/solver/constraints/air.h"

namespace toile::solver::constraints {

namespace {

/// Share of its speed that a vertex of inverse mass `w` loses to a resistance of `strength`·speed².
double lost(double strength, double speed, double w, double h) {
  const double k = strength * speed * w * h;
  return k / (1 + k);
}

}  // namespace

void drag_cloth(const AirDrag& air, std::span<const Tri> triangles, std::span<const double> w, double h,
                std::span<const Vec3> x, std::span<Vec3> v) {
  if (!(air.density > 0)) return;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 twice = cross(x[b] - x[a], x[c] - x[a]);
    const double size = length(twice);
    if (!(size > 0)) continue;
    const Vec3 n = twice * (1 / size);
    const double third = air.density * size / 12;  // ½ ρ times a third of the area
    for (const Index i : {a, b, c}) {
      const Vec3 relative = v[i] - air.wind;
      const double across = dot(relative, n);
      const Vec3 sliding = relative - n * across;
      v[i] -= n * (across * lost(third * air.across, std::abs(across), w[i], h)) +
              sliding * lost(third * air.along, length(sliding), w[i], h);
    }
  }
}

}  // namespace toile::solver::constraints
