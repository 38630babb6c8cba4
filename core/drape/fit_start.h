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
/// nowhere, `start` keeps the findings of the whole.
///
/// What `effort` does not suffice for is not tried; a finding tells where that keeps the garment from being
/// put on.
FittedStart fit_start(const DrapeInput& input, DrapeStart& start, const RunContext& context,
                      dressing::Effort effort = dressing::Effort());

/// The input without the panels of which `out` is true. `start` is of the whole.
DrapeInput without_panels(const DrapeInput& input, const DrapeStart& start, const std::vector<bool>& out);

}  // namespace toile::drape
