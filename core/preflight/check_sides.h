#pragma once
// Which way pieces and seams run: sewn crosswise, turned round, inside out.

#include "core/preflight/body_probe.h"
#include "core/preflight/preflight.h"

namespace toile::preflight {

/// Seams whose two sides run against each other where they are placed, so that their threads cross over. One
/// edge sewn to one edge is reversed here; of a series only the proposal is made. Code: seam.twisted.
void untwist_seams(const PreflightInput& input, sewing::Assembly& assembly, Findings& findings);

/// Pieces whose threads would be much shorter if the piece were turned by half a turn in its own plane, or
/// so that left and right swap: the piece is turned round unless that brings it into something. Code:
/// piece.turned.
void turn_pieces(const PreflightInput& input, std::span<const BodyProbe> probes, sewing::Assembly& assembly,
                 Findings& findings);

/// Whether the right sides fit together, by seams and by where pieces face. Codes: seam.one_sided,
/// piece.inside_out, piece.winds_other_way.
void check_sides(const PreflightInput& input, std::span<const BodyProbe> probes,
                 const sewing::Assembly& assembly, Findings& findings);

}  // namespace toile::preflight
