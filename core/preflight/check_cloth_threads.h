#pragma once

#include "core/preflight/preflight.h"

namespace toile::preflight {

/// Threads that run through a third piece where the pieces stand: what they draw together meets it, and the
/// seam stays open unless they slide off its edge. Code seam.thread_through_cloth: a warning where a thread
/// runs through the piece's middle, a note where it is near its edge; with both names and the way out.
void check_cloth_threads(const PreflightInput& input, const sewing::Assembly& assembly, Findings& findings);

/// Pieces that are sewn on across a seam which is itself open at the start: a collar or hood on a neckline, a
/// sleeve on an armhole. Threads of both pull at the same time, and what closes last may be in the way. Code
/// seam.on_open_ring (a note) with the piece and the seams that it runs across.
void check_open_rings(const PreflightInput& input, const sewing::Assembly& assembly, Findings& findings);

}  // namespace toile::preflight
