#pragma once
// The garment put together: all panels in one vertex list, where each stands, and what is sewn to what.

#include "core/base/result.h"
#include "core/mesh/panel_mesh.h"
#include "core/sewing/attachment.h"
#include "core/sewing/garment_mesh.h"
#include "core/sewing/placement.h"

namespace toile {

struct Assembly {
  GarmentMesh garment;
  std::vector<Vec3> positions;               ///< m, the start
  std::vector<std::vector<Index>> attached;  ///< garment vertices of each attachment, rising
};

/// Least vertex of the class that each vertex belongs to when the pairs `joined` are one.
std::vector<Index> least_of_class(Index vertex_count, const std::vector<std::array<Index, 2>>& joined);

/// Error: placement.count when there is not one placement for every panel, placement.not_finite with the
/// panel.
Result<Assembly> assemble(const PanelMeshes& meshes, const std::vector<Placement>& placements,
                          const std::vector<Attachment>& attachments);

}  // namespace toile
