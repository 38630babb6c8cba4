#pragma once

#include <span>
#include <vector>

#include "core/dressing/person.h"
#include "core/sewing/assembly.h"
#include "core/solver/constraints/shoulder_hold.h"

namespace toile::drape {

/// What keeps a garment on both shoulders of a wearer: no cloth there slides farther out than its piece was
/// placed, or than near the shoulder's outer end where that was nearer to the neck, unless some of it lies at
/// the neck. Sleeves are for the arm, and free. `vertex_of[i]` is the solver's vertex of garment vertex i.
std::vector<solver::constraints::ShoulderHold> make_shoulder_holds(const sewing::Assembly& assembly,
                                                                   const measure::BodyFigure& figure,
                                                                   std::span<const Index> vertex_of,
                                                                   Index vertex_count);

}  // namespace toile::drape
