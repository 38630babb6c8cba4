#pragma once
// A tube of cloth with air under pressure in it: its tension around is pressure times radius, whatever the
// cloth (Laplace), and its strain what the cloth makes of that tension.

#include "core/material/fabric.h"

namespace toile::trials {

/// A tube of 100 mm across and 150 mm long, sewn along its length, its ends capped and free, filled until it
/// stretches by half a per cent around.
struct TubeResult {
  double known = 0;     ///< N/m, what it resists with so: (c11 c22 − c12²) / (c22 − c12 / 2)
  double measured = 0;  ///< N/m: pressure times radius over the strain of the middle third
};

TubeResult tube(const material::Fabric& fabric, bool warp_around);

}  // namespace toile::trials
