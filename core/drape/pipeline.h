#pragma once
// The one place where the order of a drape is written:
// Pattern → PanelMeshes → Assembly → ClothState → Frames → result.

#include "core/base/result.h"
#include "core/base/run_context.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/drape/frame_sink.h"

namespace toile {

/// Drapes `input` and returns the end, settled or not. `sink` may be null. Progress phases: "mesh", "place",
/// "sew", "drape", "check". A cancelled drape is no error: it returns what there is, stop_reason "cancelled".
/// Errors: pattern.*, mesh.*, placement.* with the piece or seam at fault.
Result<DrapeResult> drape(const DrapeInput& input, const RunContext& context, FrameSink* sink);

}  // namespace toile
