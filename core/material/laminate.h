#pragma once

#include <algorithm>

#include "core/material/fabric.h"

namespace toile::material {

/// Bending rigidity (N·m) of two layers that are fused over their whole area: each bends by itself, and
/// beyond that one is stretched while the other is pressed, K1 K2 / (K1 + K2) d² for stiffnesses K (N/m) and
/// the distance d (m) of their middles: the theory of laminates. A bond that gives way has less.
inline double fused_rigidity(double bend1, double stretch1, double bend2, double stretch2, double distance) {
  return bend1 + bend2 + stretch1 * stretch2 / (stretch1 + stretch2) * distance * distance;
}

/// `fabric` with an interlining fused to it, grain on grain. Its look, name and friction stay.
inline Fabric fused(Fabric fabric, const Fabric& other) {
  const double distance = (fabric.thickness + other.thickness) / 2;
  const Fabric alone = fabric;
  const auto limit = [](double a, double b) { return a > 0 && b > 0 ? std::min(a, b) : std::max(a, b); };
  const auto bend = [&](double own, double others, double stretch, double other_stretch) {
    return fused_rigidity(own, stretch, others, other_stretch, distance);
  };
  const auto mean = [](const Fabric& f) { return (f.stretch_warp + f.stretch_weft) / 2; };
  fabric.areal_mass += other.areal_mass;
  fabric.stretch_warp += other.stretch_warp;
  fabric.stretch_weft += other.stretch_weft;
  fabric.stretch_coupling += other.stretch_coupling;
  fabric.stretch_shear += other.stretch_shear;
  fabric.limit_warp = limit(alone.limit_warp, other.limit_warp);
  fabric.limit_weft = limit(alone.limit_weft, other.limit_weft);
  fabric.limit_shear = limit(alone.limit_shear, other.limit_shear);
  fabric.bend_warp = bend(alone.bend_warp, other.bend_warp, alone.stretch_warp, other.stretch_warp);
  fabric.bend_weft = bend(alone.bend_weft, other.bend_weft, alone.stretch_weft, other.stretch_weft);
  fabric.bend_bias = bend(alone.bend_bias, other.bend_bias, mean(alone), mean(other));
  fabric.thickness += other.thickness;
  return fabric;
}

}  // namespace toile::material
