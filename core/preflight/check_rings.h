#pragma once

#include "core/preflight/body_probe.h"
#include "core/preflight/preflight.h"

namespace toile::preflight {

/// The rings that the seams make (hem, waist, cuffs, neck: the borders of the sewn garment) against what of
/// the bodies goes through them. Codes: ring.tight (a warning) with both girths, ring.around_nothing (a
/// note), ring.wrong_limb (a warning) where two that are alike go around limbs that are no pair.
void check_rings(const PreflightInput& input, std::span<const BodyProbe> probes,
                 const sewing::Assembly& assembly, Findings& findings);

}  // namespace toile::preflight
