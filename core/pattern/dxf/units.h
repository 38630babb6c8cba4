#pragma once
// Which unit a drawing is in.

#include <optional>
#include <string>
#include <vector>

#include "core/base/types.h"
#include "core/pattern/dxf/entities.h"
#include "core/pattern/dxf/read.h"

namespace toile::dxf {

/// What a text of the drawing says of its unit.
struct DxfUnitText {
  std::string words;  ///< "METRIC", "ENGLISH", "mm", …
  int line = 0;
};

/// The unit that agrees best with the header, the texts and the sizes of the pieces. `sizes`: width and
/// height of each piece, in drawing units.
///
/// Each unit starts with a small preference and gathers evidence as logarithms of likelihood: what $INSUNITS
/// states counts e¹⁰, "METRIC" makes millimetres and centimetres likely, "ENGLISH" inches, $MEASUREMENT a
/// little, and a largest piece far off 0.3 to 2.5 m, or a garment with no piece 15 cm wide, makes a unit
/// unlikely. The confidence is the winner's share.
DxfUnit decide_unit(const DxfFile& file, const std::vector<DxfUnitText>& texts,
                    const std::vector<Vec2>& sizes);

/// The unit that the settings ask for.
DxfUnit given_unit(double mm_per_unit);

/// Why a unit that was asked for is hardly meant: nobody wears pieces of that size, and the drawing's own
/// unit (decide_unit) makes garments of them. Nothing where that cannot be said.
std::optional<DxfUnitDoubt> doubt_of_given(const DxfUnit& given, const DxfUnit& own,
                                           const std::vector<Vec2>& sizes);

/// The doubt in a sentence. REQUIRES that there is one.
std::string doubt_text(const DxfUnit& given);

}  // namespace toile::dxf
