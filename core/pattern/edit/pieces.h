#pragma once
// Edits of whole pieces, their lines and grain, and of seams. Internal to the edits; each changes `pattern`
// and leaves it unspecified after an error.

#include "core/base/result.h"
#include "core/pattern/edit/edit.h"

namespace toile::edit {

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const MirrorPiece& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RotateGrain& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const AddLine& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RemoveLine& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const MovePiece& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RenamePiece& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const DuplicatePiece& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const DeletePiece& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const SetFabric& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const AddSeam& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RemoveSeam& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const ReverseSeam& edit);

}  // namespace toile::edit
