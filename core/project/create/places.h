#pragma once
// What the arrangement decides, in the document's own words and units.

#include <optional>
#include <span>

#include "core/body/measure/segments.h"
#include "core/drape/drape_input.h"
#include "core/pattern/pattern.h"
#include "core/project/project.h"
#include "core/sewing/attachment.h"
#include "core/sewing/placement.h"

namespace toile::create {

/// Lengths are rounded to a hundredth of a millimetre, angles to a millionth of a degree.
project::ProjectPlacement project_placement(const sewing::Placement& placement);

/// The same sheet told by the box side that it is parallel to and nearest to, with the flat point `anchor`
/// (m) in place; nothing when it is parallel to none.
std::optional<project::ProjectOnBox> project_on_box(const sewing::RigidPlacement& rigid, Vec2 anchor,
                                                    std::span<const measure::PartBox> boxes);

/// Tells every stiff sheet of the document by the boxes of the first body that stands, where it is parallel
/// to a side of one; others stay as they are. `input` is the document resolved. Gives back how many were told
/// so.
int tell_by_boxes(const drape::DrapeInput& input, project::Project& project);

/// By the ids of its piece and edges. REQUIRES that the pattern has them.
project::ProjectAttachment project_attachment(const pattern::Pattern& pattern,
                                              const sewing::Attachment& attachment);

}  // namespace toile::create
