#pragma once
// The other halves of pieces that are cut on the fold.

#include <vector>

#include "core/pattern/dxf/fold.h"
#include "core/pattern/dxf/found.h"
#include "core/pattern/dxf/roles.h"

namespace toile::dxf {

/// Puts the whole piece in the place of the half on one side of the axis, with its holes, marks and lines.
/// False, and nothing done, when the outline does not run along the axis.
bool unfold_piece(DxfPiece& piece, const FoldAxis& axis);

/// The pieces, whole where a mirror line runs along their outlines. It comes after all that lies within them,
/// so that the other half has it too.
DxfPieces unfolded(DxfPieces pieces, const std::vector<DxfChain>& chains, const std::vector<DxfFold>& folds);

}  // namespace toile::dxf
