#pragma once
// Where an edge of a bodice lies on the body, as far as names, shapes and its neighbours tell: towards the
// middle or the side, at a shoulder, below one.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// How much the run faces the middle of the body, -1 to 1, if its piece is a side's front or back, seen from
/// outside; 0 where that is not known.
double inwards(const SeamModel& m, const SeamRun& run);

/// As inwards(), or for a half of a bodice that names no side by where its middle is: there its shoulder
/// rises, it opens, or it has its longest edge along the grain, from the neck to the hem; a side begins below
/// the armhole.
double from_side(const SeamModel& m, const SeamRun& run);

/// The direction along which a shoulder of the piece rises, towards the neck: across the grain, to the right
/// as drawn upright. 0 where none slopes.
double slopes_to(const SeamModel& m, Index panel);

/// Whether the run slopes as shoulders do: straight, and neither level nor steep.
bool is_shoulder(const SeamModel& m, const SeamRun& run);

/// Whether the run is the hollow neck of a front or back: between its shoulders, or a shoulder and the
/// middle.
bool is_neckline(const SeamModel& m, const SeamRun& run);

/// Whether the run ends off the middle of the body, so that it leaves a neck: one of two such edges of a
/// whole piece, or an edge of a half that does not begin where its middle ends.
bool leaves_neck(const SeamModel& m, const SeamRun& run);

/// Whether the run faces the side and meets an edge that faces up and leaves a neck: that is a shoulder.
bool meets_shoulder(const SeamModel& m, const SeamRun& run);

/// Whether a piece of the bodice is for that face of the body.
bool has_face(const SeamModel& m, int face);

/// Whether the back is one piece: the sides of both fronts go to it.
bool has_whole_back(const SeamModel& m);

}  // namespace toile::seams
