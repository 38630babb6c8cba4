#pragma once
// Where a drawing holds its pieces: in its entities, or in blocks, one for each piece and size.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/entities.h"
#include "core/pattern/dxf/units.h"

namespace toile {

/// All that is drawn in one place: the entities, or one insert of a block with those within it.
struct DxfPlace {
  std::vector<DxfPart> parts;  ///< empty only while it is made
  bool is_block = false;
  std::string block;  ///< the block's name
  std::string name;   ///< what its texts state, else the block's name without its size
  bool name_is_stated = false;
  std::string size;                        ///< empty: none
  std::vector<const DxfText*> statements;  ///< "Key: value" of the block
  std::vector<const DxfText*> inherited;   ///< those of the sample size, where this one has none
  int line = 0;
};

/// What the file says of itself as a whole.
struct DxfStyle {
  std::string name, sample_size;
  std::vector<DxfUnitText> units;
};

struct DxfLayout {
  std::vector<DxfPlace> places;
  DxfStyle style;
  std::vector<std::string> sizes;  ///< of a graded file, in its order
  std::string size;                ///< the one that `places` hold
};

/// The places of one size, in the file's order; what is left out is told in the log. Error: dxf.unknown_size,
/// dxf.too_large.
Result<DxfLayout> layout_of(DxfFile& file, const DxfSettings& settings);

}  // namespace toile
