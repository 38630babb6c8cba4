#pragma once

#include "core/preflight/body_probe.h"
#include "core/preflight/preflight.h"

namespace toile::preflight {

inline constexpr int kWays = 8;              ///< directions across a thread
inline constexpr std::size_t kLookedAt = 5;  ///< threads of a seam that are looked at closely

/// Where a direction points to: "the body's left", "the floor".
std::string way_text(Vec3 way);

/// Threads run straight from stitch to stitch at the start. One that runs through a body slides off it while
/// it shortens, unless it runs through the middle of a limb or trunk: then its seam stays open. Code
/// seam.thread_through_body: an error where it cannot slide off, a note where it can (over a shoulder); code
/// seam.thread_near_limb, a note: a slim limb stands within two centimetres of the thread.
void check_threads(const PreflightInput& input, std::span<const BodyProbe> probes,
                   const sewing::Assembly& assembly, Findings& findings);

}  // namespace toile::preflight
