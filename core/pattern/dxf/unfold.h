#pragma once
// The other halves of pieces that are cut on the fold.

#include <vector>

#include "core/pattern/dxf/found.h"
#include "core/pattern/dxf/roles.h"

namespace toile::dxf {

/// The pieces, whole where a mirror line runs along their outlines. It comes after all that lies within them,
/// so that the other half has it too.
DxfPieces unfolded(DxfPieces pieces, const std::vector<DxfChain>& chains, const std::vector<DxfFold>& folds);

}  // namespace toile::dxf
