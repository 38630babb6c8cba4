#pragma once
// What hangs together by seams.

#include <vector>

#include "core/base/types.h"
#include "core/mesh/panel_mesh.h"

namespace toile::mesh {

/// Panels that seams join, directly or by others.
struct SewnPart {
  std::vector<Index> panels;  ///< rising
  double area = 0;            ///< m², flat
  int seams = 0;              ///< darts included
  /// Lengths of the closed lines that bound the sewn cloth, m, longest first; a disc has one, a tube two.
  std::vector<double> borders;
};

/// All parts, each panel in one of them, in the order of their first panels.
std::vector<SewnPart> sewn_parts(const PanelMeshes& meshes);

}  // namespace toile::mesh
