#pragma once
// Corners where two edges run past each other: drafting programs draw a neckline's arc beyond the shoulder
// that it should end on.

#include <string>
#include <vector>

#include "core/pattern/pattern.h"

namespace toile::garmentcode {

/// Ends two neighbouring edges where they cross, where the loop that they make beyond is small beside the
/// panel; its edges keep their number and order. The panel runs counter-clockwise. Gives back where that was
/// done, in words, mm.
std::vector<std::string> trim_crossing_corners(pattern::Panel& panel);

}  // namespace toile::garmentcode
