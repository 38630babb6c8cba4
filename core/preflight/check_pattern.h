#pragma once
// What the flat pattern alone tells, given how large the bodies are.

#include "core/preflight/body_probe.h"
#include "core/preflight/preflight.h"

namespace toile::preflight {

/// Gathers of 1:3 are sewn; what is a hair over is rounding.
inline constexpr double kMostGathered = 3.02;

/// Sizes: pieces against bodies and against what they are sewn to, edges against the particle distance, the
/// two sides of seams against each other, places against the bodies. Codes: piece.scale, piece.far,
/// edge.short, seam.length_difference, seam.length_ratio.
void check_sizes(const PreflightInput& input, std::span<const BodyProbe> probes,
                 const sewing::Assembly& assembly, Findings& findings);

/// Mean place of the seam's sewn vertices, m.
Vec3 place_of_seam(const sewing::Assembly& assembly, Index seam);

}  // namespace toile::preflight
