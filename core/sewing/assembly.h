#pragma once
// The garment put together: all panels in one vertex list, where each stands, and what is sewn to what.

#include "core/base/result.h"
#include "core/mesh/panel_mesh.h"
#include "core/sewing/attachment.h"
#include "core/sewing/folded_start.h"
#include "core/sewing/garment_mesh.h"
#include "core/sewing/notion_places.h"
#include "core/sewing/placement.h"

namespace toile::sewing {

struct Assembly {
  GarmentMesh garment;
  std::vector<Vec3> positions;               ///< m, the start
  std::vector<std::vector<Index>> attached;  ///< garment vertices of each attachment, rising
  std::vector<std::vector<ClothPoint>> led;  ///< what of each attachment goes to its goal
  NotionPlaces notions;
  /// Edges of the mesh about which a part of its piece begins turned over (folded_start.h).
  std::vector<std::array<Index, 2>> turned = {};
  std::vector<PressedBack> pressed_back = {};  ///< as garment vertices
};

/// Least vertex of the class that each vertex belongs to when the pairs `joined` are one.
std::vector<Index> least_of_class(Index vertex_count, const std::vector<std::array<Index, 2>>& joined);

/// The vertices of a garment some of whose sewn ones have become one.
struct JoinedVertices {
  std::vector<Index> vertex_of;  ///< of each garment vertex
  Index count = 0;
};

/// When each garment vertex that is marked in `joined` is one with the least vertex of its class.
JoinedVertices joined_vertices(const GarmentMesh& garment, const std::vector<bool>& joined);

/// Where each garment vertex would be if the sewn ones were together: the mean over its class, m.
std::vector<Vec3> together_at_means(const GarmentMesh& garment, std::span<const Vec3> positions);

/// m of seam that each pair of garment.sewn holds, half way to the pairs before and after it, on the side
/// where that is less; 0 where a side has no length there. One entry a pair.
std::vector<double> seam_held_by_pairs(const GarmentMesh& garment);

/// Error: placement.count when there is not one placement for every panel, placement.not_finite with the
/// panel, attachment.off_piece where a point lies beside its piece, and those of locate_notions.
Result<Assembly> assemble(const mesh::PanelMeshes& meshes, const std::vector<Placement>& placements,
                          const std::vector<Attachment>& attachments, const Notions& notions = {});

}  // namespace toile::sewing
