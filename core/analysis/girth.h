#pragma once
// How far it is around a garment: the shortest way through its cloth that goes once around something.

#include <optional>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"

namespace toile::analysis {

/// Where a tape would lie.
struct TapePlane {
  Vec3 inside;                       ///< m, in the plane: the tape goes around this point
  Vec3 normal;                       ///< unit
  std::optional<Vec3> outside = {};  ///< m, in the plane: and not around this one (the other leg, the trunk)
};

struct GarmentGirth {
  double flat = 0;            ///< m, of the pattern: what the way measures on the flat pieces
  double worn = 0;            ///< m, the same way in space, folds and stretch as they hang
  double compliance = 0;      ///< strain per N/m of tension along the way, on the average
  std::vector<Vec3> way;      ///< m, its corners in order
  std::vector<Index> panels;  ///< that it goes through, ascending
};

/// Of all closed ways through the cloth within the plane that go once around `inside` and not around
/// `outside`, the one whose flat length is least: of layers the tightest, of what lies double the shorter
/// way. A seam that is open by more than a centimetre is no way. Nothing where the cloth does not close.
std::optional<GarmentGirth> girth_around(const drape::DrapeInput& input, const drape::DrapeResult& result,
                                         const TapePlane& plane);

}  // namespace toile::analysis
