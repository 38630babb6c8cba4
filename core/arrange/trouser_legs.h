#pragma once
// Trousers on legs that stand as they do.

#include <vector>

#include "core/arrange/body_stand.h"
#include "core/arrange/flat_layout.h"

namespace toile::arrange {

/// The layout with the pieces of each leg among `members` turned about the top of their inner seam until the
/// hem hangs over the ankle: cut legs spread as the crotch curve has it, and threads of hems that stand
/// beside the feet would catch on them.
FlatLayout with_legs_over_legs(const GarmentGraph& graph, const std::vector<Index>& members,
                               const BodyStand& stand, FlatLayout layout);

}  // namespace toile::arrange
