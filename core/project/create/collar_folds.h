#pragma once
// Collars that are worn turned down: the fall of a shirt's collar, pressed back onto its stand, flat collars,
// pressed back onto the garment, and collars of one piece that turn over within, about where a stand would
// end.

#include <vector>

#include "core/pattern/pattern.h"
#include "core/project/project.h"

namespace toile::create {

/// A collar that turns down, as a document has it.
struct CollarFold {
  Index panel = kNone;
  project::ProjectFold fold;
  std::vector<project::ProjectLine> lines;  ///< of the piece, which the fold needs besides those it has
  Index stand = kNone;                      ///< panel that it is sewn to, where that is one
};

/// One of each collar whose ends are free and that is sewn by one side to a stand; or to the neck with an
/// outer edge so much longer than the neck that it lies flat; or too broad to stand, unless it is no longer
/// outside and a zip may close it. Collars that stand get none. REQUIRES the pattern's seams.
std::vector<CollarFold> collar_folds(const pattern::Pattern& pattern);

}  // namespace toile::create
