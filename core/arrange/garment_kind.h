#pragma once
// What a garment is where the names of its pieces do not say it.

#include <span>
#include <string>
#include <vector>

#include "core/arrange/garment_graph.h"

namespace toile::arrange {

/// What a garment covers whose sewn cloth is bounded by lines of these lengths (m, longest first), on a
/// person with a waist of that girth (m). A tube that the waist fits is a skirt, one that is too narrow for
/// it goes over the head; a waist and two legs are trousers, while an open front joins neck and hem to one
/// long line beside two armholes. All else is a top.
Cover cover_by_borders(std::span<const double> borders, double waist);

/// Gives pieces whose names say nothing what the others, or the garment's borders, tell.
/// `absent`: names of pieces that belong to the garment and are not in the pattern; `waist`: girth, m.
void cover_unnamed(GarmentGraph& graph, const std::vector<std::string>& absent, double waist);

}  // namespace toile::arrange
