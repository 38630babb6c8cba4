#pragma once
// The air's resistance: per triangle ½ ρ A (Cn |vn| vn + Ct |vt| vt) against its velocity relative to the
// air, vn and vt the parts across and along the cloth. The coefficients are those of a flat plate (S. F.
// Hoerner, "Fluid-Dynamic Drag", 1965: about 1.2 face-on, a few hundredths of friction).

#include <span>

#include "core/base/types.h"

namespace toile::solver::constraints {

struct AirDrag {
  double density = 0;   ///< kg/m³; 0: no air
  double across = 1.2;  ///< drag coefficient of cloth that moves face-on
  double along = 0.05;  ///< of cloth that slides in its own plane, both faces together
  Vec3 wind;            ///< m/s
};

/// Slows the velocities `v` (m/s, one a vertex) by the air within `h` seconds. Each corner bears its
/// triangle's resistance for its own velocity over a third of the area, taken at the speed that it leaves
/// behind (linearly implicit): no density and no step makes it push back.
void drag_cloth(const AirDrag& air, std::span<const Tri> triangles, std::span<const double> w, double h,
                std::span<const Vec3> x, std::span<Vec3> v);

}  // namespace toile::solver::constraints
