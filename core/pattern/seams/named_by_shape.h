#pragma once
// What the shapes of pieces tell of their kinds where no name does, as in a file of style numbers. Parts of
// make_seam_model(); each REQUIRES what stands before it there.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether no piece's name says what covers trunk, legs or arms, or which face of the body it is for: then
/// shapes may.
bool names_nothing(const SeamModel& m);

/// Kinds of pieces that shoulders and crotches tell: bodices and legs.
void name_shapes(SeamModel& m);

/// Legs that are cut in one piece, faces of bodices and legs, then sleeves, collars and bands that fit these.
void name_by_fit(SeamModel& m);

/// Sleeves under names of no language, of a bodice that is told by its names: pairs with a bent cap between
/// two edges of one length. REQUIRES twins.
void name_lone_sleeves(SeamModel& m);

/// How long the necks of all bodices are, mm.
double neck_of(const SeamModel& m);

}  // namespace toile::seams
