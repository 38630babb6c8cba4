#pragma once
// Parts cloth that has gone through itself or the body: what no contact can do, since it does not know which
// side is right.

#include <span>
#include <vector>

#include "core/collision/crossings.h"
#include "core/collision/surface.h"
#include "core/dressing/axis_guard.h"
#include "core/dressing/figure.h"

namespace toile::dressing {

struct Tangle {
  int cloth_body = 0, cloth_cloth = 0;  ///< pairs of triangles that cross
  bool none() const { return cloth_body + cloth_cloth == 0; }
  int all() const { return cloth_body + cloth_cloth; }
};

struct Untangled {
  Tangle left;
  int passes = 0;  ///< that it took
};

/// Shortens the lines in which cloth crosses itself until none is left (Volino and Magnenat-Thalmann,
/// "Resolving surface collisions through intersection contour minimization", 2006), smooths the cloth there,
/// and moves what crosses the body outwards. At most `passes` times; `spacing` is the mean edge, m. Gives
/// back what is left. What is parted so may not go through a limb: a strap in the skin would leave it on the
/// wrong side of the shoulder. `guard`, if there is one, must be of `x`.
Untangled untangle(const collision::Surface& cloth, const SlimFigure& figure,
                   const collision::CrossingBody& body, double spacing, int passes, std::vector<Vec3>& x,
                   AxisGuard* guard = nullptr);

}  // namespace toile::dressing
