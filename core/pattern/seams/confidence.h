#pragma once
// How sure a proposal is of itself.

#include "core/pattern/seams/search.h"

namespace toile::seams {

/// Seams that stand or fall together become as sure as the surest of them: mirror images, what another seam
/// leads over, the middle of a back.
void share_margins(FoundSeams& found);

/// 0 to 1, of a seam whose sides are `a` and `b` mm long: by its margin, and by what outlines do not tell.
double confidence_of(const FoundSeams& found, const FoundSeam& seam, double a, double b);

/// How far the garment that was found is to be believed in, 0 to 1. Where few names tell fronts from backs,
/// and it is not known which side of the pieces one sees, another garment is often as good: what is then
/// proposed is for a person to decide.
double belief_in(const FoundSeams& found, bool sides_known);

}  // namespace toile::seams
