#pragma once
// Pieces that are pressed over begin folded: collars and lapels that had to turn over in one once the garment
// is sewn would not, since their outer edges would have to pass over what is shorter.

#include <array>
#include <vector>

#include "core/mesh/panel_mesh.h"
#include "core/sewing/notions.h"
#include "core/sewing/placement.h"

namespace toile::sewing {

/// What of a piece is pressed back along a line, or along an edge onto what that is sewn to, once the garment
/// is on: a collar's fall. Vertices of the piece's mesh, or of the garment.
struct PressedBack {
  std::vector<Index> along;  ///< in order
  std::vector<Index> fall;   ///< what is turned about them, rising
  bool up_inside = true;     ///< the side that is up in the flat piece comes inside, as for angles below 0
};

struct PlacedPiece {
  std::vector<Vec3> positions;               ///< m, one a vertex of the mesh
  std::vector<std::array<Index, 2>> turned;  ///< edges of the mesh about which a part is turned over
  std::vector<PressedBack> pressed_back = {};
};

/// Where a piece begins: placed flat (place), and where just one crease of at least 135° parts it in two, the
/// smaller part turned about the crease by its angle. Along a crease that is bent each point turns about the
/// nearest point of it, which stretches or squeezes the part; sewing brings it back to its size. A crease
/// that parts nothing leaves the piece flat, and so do several.
/// What hangs free beyond the crease, and is the larger part, or what lies beyond an edge that is pressed so
/// far begins flat: it is sewn standing and `pressed_back` later. `sewn`: of each vertex, whether a seam
/// holds it.
PlacedPiece placed_folded(const mesh::PanelMesh& mesh, const Placement& placement,
                          const std::vector<Crease>& of_panel, const std::vector<bool>& sewn);

}  // namespace toile::sewing
