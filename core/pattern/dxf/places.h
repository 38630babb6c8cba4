#pragma once
// Where a drawing holds its pieces: in its entities, or in blocks, one for each piece and size.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/polygon2.h"
#include "core/pattern/dxf/chains.h"
#include "core/pattern/dxf/entities.h"
#include "core/pattern/dxf/units.h"

namespace toile::dxf {

/// All that is drawn in one place: the entities, or one insert of a block with those within it.
struct DxfPlace {
  std::vector<DxfPart> parts;  ///< empty only while it is made
  bool is_block = false;
  std::string block;  ///< the block's name
  std::string name;   ///< what its texts state, else the block's name without its size
  bool name_is_stated = false;
  std::string size;    ///< empty: none
  std::string ending;  ///< of the block's name, where it may be a size: "42" of "FRONT_42"
  std::vector<const DxfText*> statements;  ///< "Key: value" of the block
  std::vector<const DxfText*> inherited;   ///< those of the sample size, where this one has none
  int line = 0;

  /// The block's name without its ending.
  std::string stem() const { return block.substr(0, block.size() - ending.size() - 1); }
};

/// What the file says of itself as a whole.
struct DxfStyle {
  std::string name, sample_size;
  std::vector<DxfUnitText> units;
};

/// The places of all sizes. They refer to the file, which must outlive them.
struct DxfPlaces {
  std::vector<DxfPlace> places;  ///< in the file's order
  DxfStyle style;
  DxfNotes notes;
};

/// Error: dxf.too_large.
Result<DxfPlaces> places_of(const DxfFile& file);

/// The box of all that is drawn in the block, in its own coordinates.
std::optional<Aabb2> box_of(const DxfBlock& block);

}  // namespace toile::dxf
