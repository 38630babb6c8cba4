#pragma once
// The fabric's view by coefficients from 0 to 1, and its map to real units and back. After S. Kim and C. K.
// Park, "Fast Garment Drape Simulation Using Geometrically Constrained Particle System" (2003), which leaves
// open what they measure; the map is ours:
//
//   elasticity   the largest strain: the limit of the fabric's stretch. 1 is a cloth that doubles its length.
//                A fabric without a limit has the strain at which it carries 490 N/m, the load of the KES
//                tensile test.
//   bending      the bending length (B / w)^(1/3), w the weight per area, over 50 mm, stiffer than which no
//                apparel is. So cloth of any mass hangs alike where its coefficient is the same.

#include <algorithm>
#include <cmath>

#include "core/material/fabric.h"

namespace toile::material {

inline constexpr double kStiffestLength = 0.05;  ///< m, the bending length of coefficient 1
inline constexpr double kLargestLoad = 490;      ///< N/m
/// N/m that cloth carries at its limit when only its coefficient is known: usual for wovens of the library.
inline constexpr double kLoadAtLimit = 60;

inline double elasticity_of(double stretch, double limit) {
  return std::clamp(limit > 0 ? limit : kLargestLoad / stretch, 0.0, 1.0);
}

/// Stretch stiffness (N/m) of a coefficient; the limit is the coefficient itself.
/// REQUIRES a coefficient above 0.
inline double stretch_of_elasticity(double coefficient) { return kLoadAtLimit / coefficient; }

/// `rigidity` in N·m, `areal_mass` in kg/m².
inline double bending_coefficient(double rigidity, double areal_mass) {
  constexpr double kGravity = 9.81;  // m/s²
  return std::clamp(std::cbrt(rigidity / (areal_mass * kGravity)) / kStiffestLength, 0.0, 1.0);
}

/// Bending rigidity (N·m) of a coefficient.
inline double rigidity_of_bending(double coefficient, double areal_mass) {
  constexpr double kGravity = 9.81;  // m/s²
  const double length = coefficient * kStiffestLength;
  return length * length * length * areal_mass * kGravity;
}

}  // namespace toile::material
