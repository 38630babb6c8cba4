#pragma once
// What the texts of a drawing say of its pieces: names, sizes, quantities.

#include <vector>

#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/pieces.h"
#include "core/pattern/dxf/places.h"

namespace toile {

/// Gives the pieces of a place what its texts state, and names after the texts in or beside them.
void name_pieces(std::vector<DxfFound>& pieces, const DxfPlace& place, DxfContext& context);

/// Names the nameless after the texts of the drawing that stand in them or up to 20 mm beside them, each text
/// the nearest piece; tells of all other texts.
void name_by_texts(std::vector<DxfFound>& pieces, const std::vector<DxfText>& texts,
                   const DxfTransform& to_mm, DxfContext& context);

/// Gives those without a name a number and twins a suffix.
void finish_names(std::vector<DxfFound>& pieces);

}  // namespace toile
