#pragma once

#include <string>

namespace toile::material {

/// A fabric in real units. The membrane's energy per area is ½ εᵀ K ε with ε = (warp, weft, shear
/// angle) and K = [[warp, coupling, 0], [coupling, weft, 0], [0, 0, shear]].
struct Fabric {
  std::string id;
  std::string name;

  double areal_mass = 0.2;  ///< kg/m²

  double stretch_warp = 2000;     ///< N/m, tension per strain along the warp
  double stretch_weft = 2000;     ///< N/m
  double stretch_coupling = 600;  ///< N/m, c12; |c12| < √(warp·weft)
  double stretch_shear = 700;     ///< N/m per radian of shear

  /// Strains beyond which the cloth becomes much stiffer (its yarns are straight); 0: never.
  double limit_warp = 0, limit_weft = 0;
  double limit_shear = 0;  ///< radians

  double bend_warp = 1.3e-5;  ///< N·m, bending rigidity per width of a strip cut along the warp
  double bend_weft = 1.3e-5;  ///< N·m
  double bend_bias = 1.3e-5;  ///< N·m, strip cut at 45°

  double thickness = 0.5e-3;  ///< m, also the distance that layers keep
  double friction = 0.3;      ///< Coulomb, cloth on cloth

  double colour[3] = {0.55, 0.62, 0.72};  ///< linear RGB for pictures, 0 to 1
};

}  // namespace toile::material
