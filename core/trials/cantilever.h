#pragma once
// A strip that bends under its own weight: ASTM D1388, after F. T. Peirce, "The Handle of Cloth as a
// Measurable Quantity" (1930).

#include "core/base/types.h"
#include "core/material/fabric.h"

namespace toile::trials {

/// A strip 25 mm wide, clamped level at one end, its overhang twice the bending length that is known.
struct CantileverResult {
  double known = 0;     ///< m, bending length (B / w)^(1/3) of the fabric's own figures
  double angle = 0;     ///< degrees by which the chord from clamp to tip falls; 41.5 is right
  double measured = 0;  ///< m, the bending length that Peirce's formula makes of that angle
};

/// Peirce's bending length (m) of an overhang (m) whose chord falls by `angle` degrees.
double peirce_length(double overhang, double angle);

/// `rigidity` (N·m) is the fabric's own along the strip, whose direction in the fabric is `along` with the
/// warp at (0, 1).
CantileverResult cantilever(const material::Fabric& fabric, Vec2 along, double rigidity);

}  // namespace toile::trials
