#pragma once

#include <span>

#include "core/pattern/pattern.h"
#include "core/preflight/body_probe.h"
#include "core/preflight/finding.h"
#include "core/sewing/assembly.h"

namespace toile::preflight {

/// Finds what crosses or nearly touches at the start: a piece and a body, two pieces, a piece and itself.
/// What is nearer than a millimetre is moved apart as a whole by the smallest shift that does it and makes
/// nothing else worse, five centimetres at most; pieces that stand as each other's mirror image (left and
/// right, x = 0 between them) stay so where that costs little. Codes: start.crosses_body, start.inside_body,
/// start.crosses_cloth, start.touches (errors, or warnings when repaired), start.gap (a warning, or a note
/// when repaired).
void move_apart(const pattern::Pattern& pattern, std::span<const BodyProbe> probes,
                sewing::Assembly& assembly, Findings& findings);

}  // namespace toile::preflight
