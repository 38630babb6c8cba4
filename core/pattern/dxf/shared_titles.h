#pragma once
// Texts that stand in most of a file's pieces, as the name of the style does, and so name none of them.

#include <vector>

#include "core/pattern/dxf/names.h"

namespace toile::dxf {

/// Those that are named after a text which most pieces of the file have, named after their next one that
/// fewer have; they keep it where there is none.
DxfNamed named_by_what_differs(std::vector<DxfFound> pieces);

}  // namespace toile::dxf
