#include "core/solver/constraints/hold.h"

namespace toile::solver::constraints {

void solve_height_holds(std::span<const HeldVertex> held, std::span<Vec3> x) {
  for (const HeldVertex& h : held) {
    if (h.height_only) x[h.v].y = h.target.y;
  }
}

}  // namespace toile::solver::constraints
