#pragma once
// Where the ground lies under a drape.

#include <optional>

#include "core/drape/drape_input.h"
#include "core/drape/drape_start.h"
#include "core/preflight/finding.h"

namespace toile::drape {

/// Height of the ground, m: the floor that the person stands on, or just under the cloth where that starts
/// lower, since ground lets nothing through and cloth without any would fall for ever. What was put on
/// (`on_body`) is above the floor. Nothing without a person, or where the settings want no ground.
std::optional<double> ground_under(const DrapeInput& input, const DrapeStart& start, bool on_body);

/// A finding where the ground lies below the floor. `ground`: as ground_under() has it.
void tell_low_ground(const DrapeStart& start, std::optional<double> ground, preflight::Findings& findings);

}  // namespace toile::drape
