#pragma once
// Bands around the neck and down open fronts: far longer than a neck, so that no circle around it is a start
// for them.

#include <span>
#include <vector>

#include "core/dressing/staging.h"
#include "core/sewing/assembly.h"

namespace toile::dressing {

/// Lays strips that do not close in themselves and that one of their long sides holds to pieces for the trunk
/// upon the stitches of these, wherever those begin. `x`: one position a garment vertex, m.
void lay_on_stitches(const sewing::Assembly& assembly, std::span<const Covers> covers, std::vector<Vec3>& x);

}  // namespace toile::dressing
