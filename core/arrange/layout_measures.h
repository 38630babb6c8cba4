#pragma once

#include <cstddef>
#include <vector>

#include "core/arrange/flat_layout.h"

namespace toile::arrange {

/// Nothing laid out yet.
FlatLayout empty_layout(std::size_t pieces);

/// The piece that the others are laid to: the largest front, without one the largest; of tops before skirts
/// and legs, and of what the middle goes through before what is of one hand alone. REQUIRES members.
Index root_of_trunk(const GarmentGraph& graph, const std::vector<Index>& members);

/// m, positive where pieces named left and right lie on their sides; halves of a waistband do not count.
double hands_right(const GarmentGraph& graph, const FlatLayout& layout);

/// How much higher the upper edges of the back end than those of the front, at the garment's middle, m: of
/// tops and skirts and trousers alike the front's middle is cut lower. Negative where front and back have
/// changed places, 0 where nothing lies there.
double front_is_lower(const GarmentGraph& graph, const FlatLayout& layout);

/// Where the garment's middle runs on a piece that lies at `pose`, x on the sheet: where it is sewn to pieces
/// of the other hand, else its own middle.
double middle_of(const GarmentGraph& graph, Index piece, const FlatMove& pose);

/// Brings a garment's middle to x = 0 that no piece holds there, itself its own image or another's.
void stand_in_the_middle(const GarmentGraph& graph, const std::vector<Index>& members, FlatLayout& layout);

}  // namespace toile::arrange
