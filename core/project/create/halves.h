#pragma once
// Pieces of a drawing that are one half of what is worn although the file says that they are cut once.

#include <span>
#include <vector>

#include "core/pattern/dxf/read.h"
#include "core/pattern/pattern.h"

namespace toile::create {

/// Of each piece: whether it is cut once by the file, and yet needs its mirror image. A person is as broad on
/// the left as on the right: where most pieces are cut in mirrored pairs, a front or back that is neither a
/// pair, nor its own mirror image, nor any other piece's, is a half whose count was forgotten. `panels`: one
/// per piece of the drawing, in its order.
std::vector<char> forgotten_halves(const dxf::DxfDrawing& drawing, std::span<const pattern::Panel> panels);

}  // namespace toile::create
