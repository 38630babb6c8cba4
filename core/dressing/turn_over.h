#pragma once
// Collars that are turned down. Sewn standing, a fall would never turn over by itself: its outer edge has to
// pass over what is shorter. So hands lay it over once the garment is on, each place along the seam until it
// touches.

#include <optional>
#include <span>
#include <vector>

#include "core/dressing/wearer.h"
#include "core/sewing/assembly.h"

namespace toile::dressing {

/// The shape `x` (m, one a garment vertex, sewn ones together, free of crossings) with its pieces that are
/// pressed back (Assembly::pressed_back) turned about their seams, towards the side that comes inside, each
/// place along a seam as far as the cloth and the body leave room and `share` (0 to 1) of that. What is
/// turned is stretched or squeezed for it.
std::vector<Vec3> turned_over(const sewing::Assembly& assembly, const Wearer& wearer, std::span<const Vec3> x,
                              double share);

}  // namespace toile::dressing
