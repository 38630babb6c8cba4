#pragma once
// What edits do to the parts of a document that are no pattern. Internal to this room.

#include "core/base/result.h"
#include "core/pattern/edit/edit.h"
#include "core/project/editing/edits.h"
#include "core/project/project.h"

namespace toile::editing {

/// Attachments, buttons, elastics, folds and cushions after an edit of the pattern. Error: edit.in_use.
Status follow_parts(project::Project& project, const edit::EditEffect& effect);

/// Keeps the piece where it stands in space after its flat points have been shifted, mm.
void stay_in_space(project::ProjectPiece& piece, Vec2 by);

/// What to do to `now` to get the lists of `wanted`. REQUIRES projects that differ in these lists alone.
RestoreLists difference(const project::Project& now, const project::Project& wanted);

/// Error: edit.out_of_range when a list is shorter than that.
Status restore(project::Project& project, const RestoreLists& edit);

}  // namespace toile::editing
