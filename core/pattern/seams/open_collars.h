#pragma once
// Collars that are open in front on a neck that no edge opens, as a polo shirt's, whose slit is only cut in,
// or a sailor's on a V.

#include "core/pattern/pattern.h"
#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether the seam would make a ring of what goes around the neck of a garment that opens there, or of a
/// broad collar on a neck that is a V. The search may find one all the same: closed, a collar fits its neck
/// best.
bool closes_open_collar(const SeamModel& model, const pattern::Seam& seam);

/// A seam all around the neck of a garment that opens there begins and ends in the middle of its front, where
/// the search may have begun to walk at a shoulder: between its halves, or an edge is parted there. Others
/// stay. The panels and edges of the seam are those of the model.
void begin_in_front(const SeamModel& model, pattern::Seam& seam);

}  // namespace toile::seams
