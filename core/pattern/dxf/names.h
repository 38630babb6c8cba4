#pragma once
// What the texts of a drawing say of its pieces: names, sizes, quantities.

#include <vector>

#include "core/pattern/dxf/found.h"
#include "core/pattern/dxf/places.h"

namespace toile::dxf {

/// Pieces with what texts say of them.
struct DxfNamed {
  std::vector<DxfFound> pieces;
  DxfNotes notes;
};

/// The pieces of a place with what its texts state, and named after the texts in or beside them. Texts that
/// the log tells of already say nothing more.
DxfNamed named_by_place(std::vector<DxfFound> pieces, const DxfPlace& place, double mm_per_unit,
                        const DxfLog& log);

/// The nameless named after the texts of the drawing that stand in them or up to 20 mm beside them, each text
/// the nearest piece; tells of all other texts.
DxfNamed named_by_texts(std::vector<DxfFound> pieces, const std::vector<DxfText>& texts,
                        const DxfTransform& to_mm, const DxfLog& log);

/// With the quantities that names tell, where nothing else tells any: but not where all names tell the same,
/// which is a size then, nor where each of several pieces of one name is drawn.
std::vector<DxfFound> counted_by_names(std::vector<DxfFound> pieces);

/// Those without a name get a number and twins a suffix.
std::vector<DxfFound> named_apart(std::vector<DxfFound> pieces);

}  // namespace toile::dxf
