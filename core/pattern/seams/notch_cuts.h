#pragma once
// Edges that end a seam at a notch: a kimono's body takes its sleeve from the shoulder to the notch, a bib a
// strap's end between two.

#include <vector>

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Of every run the distances (mm from its start, rising) of those notches that bound a part as long as a run
/// of another piece, or as a part between notches of it. A run that has a partner of its own length is cut
/// only for a run that has none.
std::vector<std::vector<double>> notch_cuts(const SeamModel& model);

}  // namespace toile::seams
