#pragma once
// All tests of one fabric, and the sheet that shows them.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/fabric/card.h"
#include "core/trials/cantilever.h"
#include "core/trials/cusick.h"
#include "core/trials/shear.h"
#include "core/trials/slide.h"
#include "core/trials/tension.h"
#include "core/trials/tube.h"

namespace toile::trials {

struct FabricTrial {
  CantileverResult warp, weft, bias;
  TensionResult pull_warp, pull_weft;
  ShearResult shear;
  TubeResult tube_warp, tube_weft;  ///< warp or weft around
  SlideResult slide;
  std::vector<CusickDrape> drapes;
  double particle_distance = 0;  ///< m, of the drapes

  double coefficient() const;  ///< mean of the drapes
  double spread() const;       ///< largest less least coefficient
  double nodes() const;        ///< mean
  int settled() const;         ///< how many drapes came to rest
};

/// Tests the fabric; `drapes` of the six Cusick drapes, with triangles that fit the fabric where
/// `particle_distance` (m) is 0. Progress phase: "test". Error: "cancelled".
Result<FabricTrial> try_fabric(const material::Fabric& fabric, int drapes, double particle_distance,
                               const RunContext& context);

/// An SVG picture with the shadow of the first drape, the stretch curves, and what was found beside what was
/// known.
std::string figure_sheet(const fabric::FabricCard& card, const FabricTrial& trial);

}  // namespace toile::trials
