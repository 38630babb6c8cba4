#pragma once

#include <cmath>

namespace toile::material {

/// What a fabric with the value `warp` along its warp and `weft` along its weft has at the angle `angle`
/// (radians) from the warp: the radius there of the ellipse with these half axes. 0 when both are 0. The
/// fabric's view by coefficients from 0 to 1: elasticity goes by a link's own direction, bending by the
/// direction across it. After S. Kim and C. K. Park, "Fast Garment Drape Simulation Using Geometrically
/// Constrained Particle System" (2003). REQUIRES values that are not negative.
inline double elliptical(double warp, double weft, double angle) {
  const double across = std::hypot(weft * std::cos(angle), warp * std::sin(angle));
  return across > 0 ? warp * weft / across : 0;
}

}  // namespace toile::material
