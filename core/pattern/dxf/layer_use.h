#pragma once
// The layers of a drawing: what stands on them, what they are read as, and what a person says of them.

#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/entities.h"
#include "core/pattern/dxf/layers.h"
#include "core/pattern/dxf/places.h"
#include "core/pattern/dxf/report.h"

namespace toile::dxf {

/// The layers that any entity of the report stands on, those with numbers first. `places`: that are read.
std::vector<DxfLayerUse> layer_uses(const DxfReport& report, const std::vector<DxfPlace>& places,
                                    const DxfLayerMap& given);

/// Error: dxf.unknown_layer, where the file has no layer that is given a role.
Status check_layers(const DxfFile& file, const DxfLayerMap& given);

/// The file without the lines, points and free texts of layers that are to be ignored. Statements such as
/// "Piece Name: …" stay, and so do INSERTs, whose blocks have layers of their own.
DxfFile without_ignored(DxfFile file, const DxfLayerMap& given);

}  // namespace toile::dxf
