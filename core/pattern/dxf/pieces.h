#pragma once
// From the lines of one place of a drawing to its pieces: the passes in their order.

#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/found.h"
#include "core/pattern/dxf/places.h"

namespace toile::dxf {

struct DxfPlacePieces {
  std::vector<DxfFound> pieces;  ///< by line, without names; none when nothing there closes
  std::size_t drawn = 0;         ///< points over the whole drawing so far
  DxfNotes notes;
};

/// The pieces that one place makes, numbered from `first_id`. `drawn`: points over the drawing so far. Error:
/// dxf.too_large; what else is wrong is told in the notes.
Result<DxfPlacePieces> pieces_of(const DxfPlace& place, const DxfReading& reading, std::size_t drawn,
                                 int first_id);

}  // namespace toile::dxf
