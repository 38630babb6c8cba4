#pragma once

#include <span>

#include "core/preflight/preflight.h"

namespace toile::preflight {

/// Pieces of a higher layer against those of lower ones: at the start they must lie farther from the body.
/// Seen from each vertex of the higher piece, the lower one may lie towards the body or away from it; where
/// most of what is seen of it lies away, the order is wrong. Nothing is asked without a body, or where all
/// layers are one. Code: layer.inside (a warning) with both pieces.
void check_layers(const PreflightInput& input, const sewing::Assembly& assembly, Findings& findings);

}  // namespace toile::preflight
