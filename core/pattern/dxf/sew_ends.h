#pragma once
// Sew lines that are drawn only where there is an allowance.

#include <vector>

#include "core/pattern/dxf/roles.h"

namespace toile::dxf {

/// The chains, with those open sew lines closed that begin and end on a cut line and follow it between: they
/// go on along it, as at a fold or an edge that is not sewn.
DxfClosed closed_at_cut_lines(std::vector<DxfChain> chains, const DxfRoles& roles);

}  // namespace toile::dxf
