#pragma once
// Vertices led by hand: held at a height, or in a place.

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::solver::constraints {

struct HeldVertex {
  Index v = kNone;
  bool height_only = true;
  Vec3 target;  ///< m
};

/// Puts vertices that are held at a height back there. Those held in a place have no inverse mass; they are
/// led before the constraints, which then see them where they are. Contact bounds come after both: a
/// prescribed motion waits.
void solve_height_holds(std::span<const HeldVertex> held, std::span<Vec3> x);

}  // namespace toile::solver::constraints
