#pragma once
// Where an edge is likely to be sewn to several: a sleeve's cap at the armholes' ends, a band at a waist's.

#include "core/pattern/seams/model.h"

namespace toile::seams {

enum class CutKind {
  kDarts,        ///< only edges that meet a line with darts in it
  kExactFirst,   ///< those, and edges that meet two others end to end and are as long as these together
  kExactSecond,  ///< the same, the two in the other order
  kFirstFirst,   ///< those, and edges that meet two others end to end, with a little ease
  kSecondFirst,  ///< the same, the two in the other order
  kNotches,      ///< edges at notches that bound a part with a partner, and then as kExactFirst
};

/// Whether the panel is one side's of what it is a part of, and there is the other side's.
bool is_half(const SeamModel& model, Index panel);

/// Whether the panel is a band that names no side and no face, and fronts and backs hang from it or hold it:
/// it is sewn to all of them together.
bool goes_all_around(const SeamModel& model, Index panel);

/// Whether the run lies at the upper or lower end of a whole piece and halves come to that end, as those of a
/// bodice to a band: each of them then has its half of the end.
bool meets_halves(const SeamModel& model, Index run);

/// The model with runs cut at the ends of what they are probably sewn to, in proportion. A run that is as
/// long as a line of another piece with darts in it (a back's side and a front's) is cut at the darts, and
/// the line's own parts are left whole; so is one that is exactly as long as two edges with a blunt corner.
/// One that is as long as two others together whose neighbours are alike, so that these two would lie end to
/// end when sewn, is cut where they meet. Runs with a partner of their own length are left whole.
SeamModel with_likely_cuts(const pattern::Pattern& pattern, SeamModel model, CutKind kind);

}  // namespace toile::seams
