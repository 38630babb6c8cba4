#pragma once
// The pieces of a drawing as they are cut and worn: darts cut out, doubled cloth folded, what lies under
// other cloth gone, fronts whole at their pockets.

#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/read.h"
#include "core/pattern/pattern.h"

namespace toile::create {

/// A drawing's pieces as they lie in it, those that can be cut.
struct CutPieces {
  dxf::DxfDrawing drawing;             ///< without the others
  std::vector<pattern::Panel> panels;  ///< one a piece of it
  std::vector<char> filled;            ///< of each: its outline is no longer the drawing's
};

/// What cannot be cut is left out with a note, as long as anything is left: one bad outline of many must not
/// keep the garment from being made. Error: that of the first, where none can be cut.
Result<CutPieces> cut_pieces(const dxf::DxfDrawing& drawing);

}  // namespace toile::create
