#pragma once
// What single edges of a piece are by their shape and place: sleeves' caps, sides of wide skirts, the edges
// of fronts that open. The parts of make_seam_model() that fill in what SeamModel says of it; each REQUIRES
// what stands before it there.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// `cap`, `tailored`, and `upright` of sleeves: their edges that bulge most, and their mirror images. A
/// sleeve whose cap is above stands, also where no grain line says so; then the others do, too.
void find_caps(SeamModel& m);

/// `side`.
void find_sides(SeamModel& m);

/// `open_front` and `opens`: fronts that close with buttons are often rounded into the hem, and no seam goes
/// there. The run's lower end is level, the upper one upright.
void find_open_fronts(SeamModel& m);

}  // namespace toile::seams
