#pragma once
// Pieces that are pressed over begin folded: collars and lapels that had to turn over in one once the garment
// is sewn would not, since their outer edges would have to pass over what is shorter.

#include <array>
#include <vector>

#include "core/mesh/panel_mesh.h"
#include "core/sewing/notions.h"
#include "core/sewing/placement.h"

namespace toile::sewing {

struct PlacedPiece {
  std::vector<Vec3> positions;               ///< m, one a vertex of the mesh
  std::vector<std::array<Index, 2>> turned;  ///< edges of the mesh about which a part is turned over
};

/// Where a piece begins: placed flat (place), and where just one crease of at least 135° parts it in two, the
/// smaller part turned about the crease by its angle. Along a crease that is bent each point turns about the
/// nearest point of it, which stretches or squeezes the part; sewing brings it back to its size. A crease
/// that parts nothing leaves the piece flat, and so do several.
PlacedPiece placed_folded(const mesh::PanelMesh& mesh, const Placement& placement,
                          const std::vector<Crease>& of_panel);

}  // namespace toile::sewing
