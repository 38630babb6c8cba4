#pragma once
// Whether what was draped lies where on the body it belongs: rings can go around the right limbs at the wrong
// place.

#include <span>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/dressing/certificate.h"
#include "core/dressing/person.h"
#include "core/preflight/finding.h"
#include "core/sewing/garment_mesh.h"

namespace toile::drape {

/// A finding for each shoulder that the garment has slid off, although pieces began as high and it goes
/// around that arm; for each piece that is a bodice's by its name and ended below the chest; for each
/// sleeve's far from both arms; and where the head goes through an armhole with the arm, or neither head nor
/// legs through what has both arms: a neck that is sewn shut looks so. `x`: m, one a garment vertex; `tops`:
/// m, the highest of each panel where it began.
preflight::Findings out_of_place(const DrapeInput& input, const measure::BodyFigure& figure,
                                 const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                                 std::span<const double> tops, std::span<const dressing::WornRing> rings);

}  // namespace toile::drape
