#pragma once
// The borders of the sewn garment: its hem, waist, cuffs and neckline as closed lines.

#include <vector>

#include "core/sewing/garment_mesh.h"

namespace toile::sewing {

/// The triangles with each corner replaced by the least vertex that it is sewn to; those that lose a corner
/// by that are left out.
std::vector<Tri> sewn_triangles(const GarmentMesh& garment);

/// Closed lines of vertices (least of their classes), whichever way each runs. Where pieces are sewn with
/// their sides against each other, the line that they share is no border.
std::vector<std::vector<Index>> rings_of(const GarmentMesh& garment);

}  // namespace toile::sewing
