#pragma once
// What of a garment hangs together by seams, as a garment of its own.

#include <vector>

#include "core/mesh/panel_mesh.h"
#include "core/pattern/pattern.h"

namespace toile::arrange {

struct GarmentPart {
  pattern::Pattern pattern;
  mesh::PanelMeshes meshes;   ///< of these panels, in their order
  std::vector<Index> panels;  ///< their numbers in the whole, rising
  double area = 0;            ///< m², flat, of what garment_parts() gives
};

/// These panels and the seams among them; `panels` rise.
GarmentPart garment_of(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes,
                       std::vector<Index> panels);

/// All parts, the largest first. `meshes` are those of `pattern`.
std::vector<GarmentPart> garment_parts(const pattern::Pattern& pattern, const mesh::PanelMeshes& meshes);

}  // namespace toile::arrange
