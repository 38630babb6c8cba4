#pragma once
// What the arrangement decides, in the document's own words and units.

#include "core/pattern/pattern.h"
#include "core/sewing/attachment.h"
#include "core/sewing/placement.h"
#include "proto/cpp/project.h"

namespace toile {

/// Lengths are rounded to a hundredth of a millimetre, angles to a millionth of a degree.
ProjectPlacement project_placement(const Placement& placement);

/// By the ids of its piece and edges. REQUIRES that the pattern has them.
ProjectAttachment project_attachment(const Pattern& pattern, const Attachment& attachment);

}  // namespace toile
