#pragma once
// Finds a start for a drape that is refused as a whole: a part that cannot be put on is left out, and named.

#include <optional>
#include <vector>

#include "core/base/run_context.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_start.h"

namespace toile::drape {

/// What became of a start.
struct FittedStart {
  bool last_start = true;             ///< no other start leads on (put_on_after)
  std::vector<bool> left_out;         ///< one a panel of the input; empty where none is
  std::optional<DrapeInput> reduced;  ///< the input without these; `start` is of this then
};

/// Puts the garment on as dress_start() does. Where no way to do so is certified and the start is refused, it
/// is tried again without the pieces that kept the way that came nearest from its certificate, and without
/// what nothing holds on then, a few times, as long as half of the cloth remains. Where that leads
/// nowhere, the pieces are left out that stand in the way of sewing the rest from where it stands, or that a
/// seam joins which would stay open; and where too little would remain, `start` keeps the findings of the
/// whole.
///
/// What `effort` does not suffice for is not tried; a finding tells where that keeps the garment from being
/// put on.
FittedStart fit_start(const DrapeInput& input, DrapeStart& start, const RunContext& context,
                      dressing::Effort effort = dressing::Effort());

/// The part that can be sewn from where it stands, without the pieces that errors about a refused start name:
/// of two that get in each other's way, or that a seam joins which would stay open, the smaller. `start`
/// becomes the part's. Nothing where there is none, or too little would remain.
std::optional<FittedStart> without_refused(const DrapeInput& input, DrapeStart& start,
                                           const RunContext& context);

/// The input without the panels of which `out` is true. `start` is of the whole.
DrapeInput without_panels(const DrapeInput& input, const DrapeStart& start, const std::vector<bool>& out);

}  // namespace toile::drape
