#pragma once

#include <string>

#include "core/base/result.h"
#include "core/pattern/pattern.h"

namespace toile::dxf {

struct DxfWriteSettings {
  double tolerance_mm = 0.02;  ///< how far a chord may pass from the curve it stands for
};

/// The pattern's pieces as ASCII DXF R12 in millimetres, the way ANSI/AAMA-292 lays a piece out: one BLOCK
/// for each; on layer 1 the outline, each edge a POLYLINE; corners as POINTs on 2, notches on 4 with their
/// depth and angle; holes on 11, lines within the piece on 8; the grain as a LINE on 7; "Piece Name: …".
/// read_dxf gives the same pieces, edges, notches and grain back. Seams and edge names have no place in DXF.
/// Errors: "dxf.nothing_to_write", "dxf.bad_name" (a name with a line break or none).
Result<std::string> write_dxf(const pattern::Pattern& pattern, const DxfWriteSettings& settings = {});

}  // namespace toile::dxf
