#pragma once
// What of the mesh attachments hold or lead.

#include "core/base/result.h"
#include "core/sewing/assembly.h"

namespace toile::sewing {

/// m; the point of an attachment's goal that is nearest to `p`. REQUIRES a goal.
Vec3 nearest_on_goal(const std::vector<Vec3>& goal, Vec3 p);

/// Fills `assembly.attached` and `assembly.led`, one entry for each attachment. REQUIRES the garment's
/// vertices. Error: attachment.off_piece, `where` naming the attachment.
Status locate_attachments(const std::vector<Attachment>& attachments, const mesh::PanelMeshes& meshes,
                          Assembly& assembly);

}  // namespace toile::sewing
