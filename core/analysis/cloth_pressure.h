#pragma once
// How hard stretched cloth presses on who wears it.

#include "core/analysis/surface_curvature.h"
#include "core/base/types.h"
#include "core/material/fabric.h"

namespace toile::analysis {

/// Strains of a triangle in its threads' directions: length change over length, and shear in radians.
struct ThreadStrain {
  double warp = 0, weft = 0, shear = 0;
};

/// N/m, as a tensor in space: what the fabric's law gives for these strains. `warp` and `weft` are the
/// threads' directions, of length 1. Cloth carries no push: it folds instead, so principal tensions below 0
/// count as 0. Beyond a limit the fabric is as much stiffer as the drape can make it; what is told there is
/// the tension at the limit, which is less.
SymmetricTensor cloth_tension(const material::Fabric& fabric, ThreadStrain strain, Vec3 warp, Vec3 weft);

/// Pa, by Laplace's law (Young 1805, Laplace 1806; of garments Kirk and Ibrahim 1966): tension times
/// curvature, over both directions; 0 where cloth is hollow, since it then stands off the skin.
double laplace_pressure(const SymmetricTensor& tension, const SymmetricTensor& curvature);

}  // namespace toile::analysis
