#pragma once
// Which lines of a drawing are outlines, which are holes, and which say nothing about the cloth's shape.

#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf_chains.h"
#include "core/pattern/dxf_notes.h"
#include "core/pattern/dxf_read.h"

namespace toile {

/// The pieces, without names, that the chains of one place make, by line; none when nothing there closes.
/// Where there are lines on AAMA layers 1 (cut) or 14 (sew) only those make pieces, sew before cut: see
/// ANSI/AAMA-292 and ASTM D6673 for the numbers. Errors: dxf.open_outline, dxf.zero_area, dxf.too_large.
Result<std::vector<DxfPiece>> pieces_of_chains(const std::vector<DxfChain>& chains,
                                               const DxfSettings& settings, DxfNotes& notes);

/// The error that a chain should close and does not.
Error open_outline(const DxfChain& chain);

}  // namespace toile
