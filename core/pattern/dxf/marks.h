#pragma once
// What belongs to a piece beside its lines: notches, turn points, drill holes.

#include <vector>

#include "core/pattern/dxf/found.h"
#include "core/pattern/dxf/roles.h"

namespace toile::dxf {

/// The pieces with the POINTs of the parts, and the short LINEs on layers of notches, each given to the piece
/// that it lies on or told of.
DxfPieces with_marks(DxfPieces pieces, const std::vector<DxfPart>& parts, const std::vector<DxfChain>& chains,
                     const DxfRoles& roles, const DxfReading& reading);

}  // namespace toile::dxf
