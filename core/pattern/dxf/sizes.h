#pragma once
// Graded files: which sizes they hold, and the places of one of them.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/dxf/places.h"

namespace toile::dxf {

/// The drawing in one size.
struct DxfLayout {
  std::vector<DxfPlace> places;  ///< of that size and of none, in the file's order
  DxfStyle style;
  std::vector<std::string> sizes;  ///< of a graded file, in its order
  std::string size;                ///< the one that `places` hold
  DxfNotes notes;                  ///< those of `all`, and what is left out
};

/// The size that the settings ask for, else the sample size. Error: dxf.unknown_size.
Result<DxfLayout> in_one_size(DxfPlaces all, const DxfSettings& settings);

}  // namespace toile::dxf
