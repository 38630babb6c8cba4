#pragma once

#include "core/preflight/body_probe.h"
#include "core/preflight/preflight.h"

namespace toile::preflight {

/// Threads run straight from stitch to stitch at the start. One that runs through a body slides off it while
/// it shortens, unless it runs through the middle of a limb or trunk: then its seam stays open. Code
/// seam.thread_through_body: an error where it cannot slide off, a note where it can (over a shoulder); code
/// seam.thread_near_limb, a note: a slim limb stands within two centimetres of the thread.
void check_threads(const PreflightInput& input, std::span<const BodyProbe> probes,
                   const sewing::Assembly& assembly, Findings& findings);

}  // namespace toile::preflight
