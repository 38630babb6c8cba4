#pragma once
// The pieces of a project document as panels: outlines from DXF files or from the document itself.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/pattern.h"
#include "core/project/project.h"
#include "core/project/resolve/opened_files.h"
#include "core/sewing/notions.h"

namespace toile::resolve {

/// One panel per piece, in their order. Errors:
/// project.unknown_piece (in the file), project.unknown_edge (in edge_names), project.path, dxf.*, pattern.*.
Result<std::vector<pattern::Panel>> panels_of(const std::vector<project::ProjectPiece>& pieces,
                                              OpenedFiles& files);

/// Makes lines that elastics or creases lie on ones that the mesh follows. Error: pattern.bad_line, where
/// such a line does not lie in its piece; the notions' place in the document.
Status follow_used_lines(const sewing::Notions& notions, pattern::Pattern& pattern);

}  // namespace toile::resolve
