#pragma once
// How a piece lies on the other that is its mirror image in the garment.

#include <optional>

#include "core/arrange/garment_graph.h"

namespace toile::arrange {

/// The isometry from the plane of piece `image` onto that of `piece`, where the two are cut alike. Strips lie
/// on each other in several ways: the one is taken in which both have the same seams, so that the edge by
/// which one cuff is sewn to its leg is none at the hem of the other.
std::optional<FlatMove> image_on(const GarmentGraph& graph, Index image, Index piece);

}  // namespace toile::arrange
