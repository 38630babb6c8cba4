#pragma once
// From a piece as it is now to the same piece as it was before an edit, both flat.

#include <vector>

#include "core/warm/hung_garment.h"

namespace toile::warm {

/// Where each vertex of `now` lay in `before`, m. Edges that both have (by id) lie on each other by shares of
/// their length; of other edges, what lies off the piece goes to the nearest place on its border. Inside,
/// ways are a harmonic function of those of the border: none where nothing was changed. `edges` are the ids
/// of now.edge_vertices.
std::vector<Vec2> places_before(const HungPiece& before, const mesh::PanelMesh& now,
                                const std::vector<std::string>& edges);

}  // namespace toile::warm
