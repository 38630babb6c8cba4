#pragma once
// Edits of the marks on a piece's outline. Internal to the edits; each changes `pattern` and leaves it
// unspecified after an error. Curves end at notches; where one is gone, curves that look like one become one.

#include "core/base/result.h"
#include "core/pattern/edit/edit.h"

namespace toile::edit {

Result<EditEffect> edit_piece(pattern::Pattern& pattern, const AddNotch& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const MoveNotch& edit);
Result<EditEffect> edit_piece(pattern::Pattern& pattern, const RemoveNotch& edit);

}  // namespace toile::edit
