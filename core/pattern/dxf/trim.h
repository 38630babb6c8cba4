#pragma once
// What belongs to a piece beside its lines: notches, turn points, drill holes; and its other half.

#include <vector>

#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/fold.h"
#include "core/pattern/dxf/pieces.h"

namespace toile {

/// A piece that marks may belong to.
struct DxfTrimmings {
  DxfFound* found = nullptr;
  Aabb2 box;
};

/// Gives the POINTs of the parts, and the short LINEs on layers of notches, to the pieces that they lie on.
void place_marks(const std::vector<DxfPart>& parts, bool by_aama, std::vector<DxfTrimmings>& pieces,
                 DxfContext& context);

/// Puts the whole piece in the place of the half on one side of the axis, with its holes, marks and lines.
/// False, and nothing done, when the outline does not run along the axis.
bool unfold_piece(DxfPiece& piece, const FoldAxis& axis);

}  // namespace toile
