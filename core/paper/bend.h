#pragma once
// Equation 6 of Kim and Park 2003: bending, told by the sum of angles around a particle.
//
// In print: α = 1 + √min(Σ θ_i·C_i/π, π/π), v = x x_prev, l = |x x_prev|, and no x_new. Beyond certain
// repair; the reading chosen here keeps all that the text says of it:
//
//     δ     = |Σ C_i·(θ_i − θ_i⁰)| / Σ θ_i⁰
//     α     = √min(δ, 1)
//     x_new = x − α·(x − x_prev)          if the fan is bent further than before the step
//
// θ_i is the angle between two neighbouring links of the fan, θ_i⁰ the same in the flat piece, so that a flat
// fan gets nothing: its sum is 2π inside, π on a straight border, the corner's angle at a corner. What seams
// join is one fan. C_i is the mean of the bending coefficients of the angle's two links, each interpolated
// for the direction across its link: 0 is limp, 1 stiff. The particle takes back the share α of the way that
// it went in the step. α grows as the square root of the deformation, so the share of the deformation that is
// recovered falls as it grows; it ends at the whole way. What moves back towards flat is not held up.
//
// The method's own limit: without strain a triangle keeps its angles, so the sum keeps its flat value however
// the cloth is folded. It feels what pushes links together, and no fold along a straight line.

#include <algorithm>
#include <cmath>

#include "core/base/types.h"

namespace toile::paper {

/// arccos to 2e-8, from M. Abramowitz and I. Stegun, "Handbook of Mathematical Functions" (1964), 4.4.46: of
/// sums and a square root only, so that it is the same on every processor.
inline double arc_cosine(double cosine) {
  const double c = std::min(std::abs(cosine), 1.0);
  double p = -0.0012624911;
  for (const double a : {0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046, 0.0889789874,
                         -0.2145988016, 1.5707963050}) {
    p = p * c + a;
  }
  const double angle = std::sqrt(1 - c) * p;
  return cosine < 0 ? 3.14159265358979323846 - angle : angle;
}

/// Radians between the links from `apex` to `a` and to `b`; 0 where one has no length.
inline double angle_between(Vec3 apex, Vec3 a, Vec3 b) {
  const Vec3 u = a - apex, v = b - apex;
  const double product = dot(u, u) * dot(v, v);
  return product > 0 ? arc_cosine(dot(u, v) / std::sqrt(product)) : 0;
}

/// α for a fan that is off its flat state by δ.
inline double recovery(double deformation) { return std::sqrt(std::min(deformation, 1.0)); }

/// Where a particle is that takes back the share `alpha` of its way.
inline Vec3 recovered(Vec3 x, Vec3 previous, double alpha) { return x - (x - previous) * alpha; }

}  // namespace toile::paper
