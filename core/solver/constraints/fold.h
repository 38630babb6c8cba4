#pragma once
// Creases: the angle between the two triangles at an edge, drawn to a rest angle. Only + − × ÷ √: with the
// sine and cosine of half the angle, which come from the triangles' normals by square roots, 4 tan(δ/4)
// stands for the difference δ to the rest angle. It is within 3 % of δ up to 70°, 27 % more at 180°, and its
// slope never vanishes, so that even a sheet that is to fold flat onto itself finds its way from flat.

#include <span>

#include "core/base/types.h"

namespace toile::solver::constraints {

/// A hinge of a crease: the edge e0 → e1 with a triangle to its left and to its right. Angles count from
/// flat; positive ones draw the wrong sides (the normals' backs) together.
struct FoldHinge {
  Index e0 = kNone, e1 = kNone, left = kNone, right = kNone;
  double half_sine = 0, half_cosine = 1;  ///< of half the rest angle
  double stiffness = 0;                   ///< N·m per radian: of the crease, times the edge's rest length
  bool turned = false;                    ///< it began at its angle, and is whole from the first step on
};

/// 4 tan(δ/4) of the hinge at x, δ being its angle less its rest angle where the crease is `pressed` (0: flat
/// yet, 1: at its own angle, as `turned` ones are always). 0 where a triangle has no area.
double fold_difference(const FoldHinge& hinge, double pressed, std::span<const Vec3> x);

/// One pass of compliant hinges (XPBD).
void solve_folds(std::span<const FoldHinge> hinges, double pressed, std::span<const double> w, double h,
                 std::span<Vec3> x);

}  // namespace toile::solver::constraints
