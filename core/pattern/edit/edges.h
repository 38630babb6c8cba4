#pragma once
// Edits by which edges of a piece come and go; the seams go with them. Internal to the edits; each changes
// `pattern` and leaves it unspecified after an error, and tells which edges have other names now.

#include <vector>

#include "core/base/result.h"
#include "core/pattern/edit/edit.h"

namespace toile::edit {

using RenamedParts = std::vector<RenamedPart>;

Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const SplitEdge& edit);
Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const JoinEdges& edit);
Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const AddDart& edit);
Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const AddInnerDart& edit);
Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const RenameEdge& edit);
Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const AddHole& edit);
Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const RemoveHole& edit);

/// The piece whose dart the seam closes. Errors: edit.unknown_seam, edit.no_dart.
Result<Index> piece_of_dart(const pattern::Pattern& pattern, const RemoveDart& edit);
Result<RenamedParts> edit_edges(pattern::Pattern& pattern, Index panel, const RemoveDart& edit);

}  // namespace toile::edit
