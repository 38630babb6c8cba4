#pragma once
// What of a bodice and of a sleeve meets around the arm.

#include "core/pattern/seams/model.h"

namespace toile::seams {

/// Whether the run may be below the arm of a sleeve that is cut on: it faces down and meets a side in a
/// corner that turns in.
bool is_below_arm(const SeamModel& model, const SeamRun& run);

/// Whether `slope` may be a raglan's beside the run `end`, which is shorter: of a bodice the end of its
/// armhole, of a sleeve its upper end. It faces up, and does not come from the hem.
bool is_raglan_slope(const SeamModel& m, const SeamRun& slope, const SeamRun& end);

/// Whether the run is the hollow end of an armhole, from a raglan sleeve's slope down to the side.
bool is_armhole_end(const SeamModel& m, const SeamRun& run);

/// Whether the run is the end of an armhole, which goes under the arm, and the other one cannot lie there.
bool is_off_armhole_end(const SeamModel& m, const SeamRun& torso, const SeamRun& other);

/// Whether the run is a bodice's edge below a shoulder: sewn front to back it lets no arm out.
bool is_for_arm(const SeamModel& m, const SeamRun& run);

/// Whether half the level top of a sleeve would be set on upside down, its seam at the shoulder and its
/// middle under the arm; `along`: sewn along the outlines' direction.
bool is_set_on_turned(const SeamModel& m, const SeamRun& torso, const SeamRun& sleeve, bool along);

/// A sleeve is sewn with its cap to a hollow edge of a bodice that does not face the middle; a tailored one
/// is eased into the armhole as a whole, so that no part of it takes a part of another length.
double armhole_merit(const SeamModel& m, const SeamRun& torso, const SeamRun& sleeve);

}  // namespace toile::seams
