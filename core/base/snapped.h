#pragma once
// What keeps last bits from deciding.

#include "core/base/types.h"

namespace toile {

/// m, rounded to 2⁻²⁶ (15 nm). Sines, cosines and sums differ in their last bit between processors, and the
/// same input must give the same bytes: where a drape begins is rounded.
inline Vec3 snapped(Vec3 p) {
  constexpr double kGrid = 0x1p26;
  return {std::nearbyint(p.x * kGrid) / kGrid, std::nearbyint(p.y * kGrid) / kGrid,
          std::nearbyint(p.z * kGrid) / kGrid};
}

}  // namespace toile
