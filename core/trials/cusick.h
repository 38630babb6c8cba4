#pragma once
// The drape of a round piece over a smaller disc: BS 5058, ISO 9073-9, after G. E. Cusick, "The Dependence of
// Fabric Drape on Bending and Shear Stiffness" (1965).

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/drape_result.h"
#include "core/material/fabric.h"

namespace toile::trials {

inline constexpr double kSpecimenRadius = 0.15, kDiscRadius = 0.09;  // m

/// The shadow of draped cloth, seen from above.
struct Shadow {
  double coefficient = 0;       ///< share of the ring between disc and flat piece that it covers
  int nodes = 0;                ///< folds
  std::vector<double> outline;  ///< m from the middle, at every degree, 0 along x
};

/// Of cloth whose middle is at x = z = 0.
Shadow shadow_of(std::span<const Vec3> positions, std::span<const Tri> triangles);

struct CusickDrape {
  Shadow shadow;
  bool settled = false;
  int particles = 0;
  double cpu_s = 0;
  drape::CrossingCount worst;  ///< of all frames that were looked at
};

/// The `number`th of six drapes: warp turned by 0, 20 and 43° against the mesh, each with either face up. The
/// piece lies on the disc and is held by friction. Error: "cancelled".
Result<CusickDrape> cusick_drape(const material::Fabric& fabric, int number, double particle_distance,
                                 const RunContext& context);

}  // namespace toile::trials
