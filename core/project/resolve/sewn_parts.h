#pragma once
// What is done to the pieces of a document: seams, notions, placements and attachments.

#include <vector>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/project/project.h"
#include "core/project/resolve/pattern_names.h"

namespace toile::resolve {

/// Errors: project.unknown_piece, project.unknown_edge.
Status add_seams(const std::vector<project::ProjectSeam>& given, const PatternNames& names,
                 std::vector<pattern::Seam>& seams);

/// Buttons, elastics, creases and cushions. Errors: as above, project.unknown_line.
Status add_notions(const project::Project& project, const PatternNames& names, sewing::Notions& notions);

/// Placements and attachments: what may be told by a body. REQUIRES `input` with panels and bodies.
/// Errors: as above, project.two_ways, project.attached_whole, and those of body_places.h.
Status add_told_by_bodies(const project::Project& project, const PatternNames& names,
                          drape::DrapeInput& input);

}  // namespace toile::resolve
