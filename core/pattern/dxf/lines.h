#pragma once
// Lines of a place that are no outlines: grain lines, lines within pieces, and what says nothing.

#include <vector>

#include "core/pattern/dxf/found.h"
#include "core/pattern/dxf/roles.h"

namespace toile::dxf {

/// The pieces with the chains that none of them uses yet, each given to the piece that it lies in or told of.
DxfPieces with_lines(DxfPieces pieces, const std::vector<DxfChain>& chains, const DxfRoles& roles);

}  // namespace toile::dxf
