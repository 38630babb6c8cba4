#pragma once

#include "core/draft/chair.h"
#include "core/draft/garment.h"

namespace toile::draft {

/// Millimetres.
struct ChairCoverStyle {
  double ease = 4;          ///< the cover is so much farther out than the chair on each side
  double above_floor = 15;  ///< where the hem ends
  double flare = 30;        ///< each part of the skirt is so much wider below, on each side
};

/// A fitted cover down to the floor: "seat", "inside back", "outside back", "top boxing", "left boxing" and
/// "right boxing" around the back's thickness, and a skirt of "front skirt", "back skirt", "left skirt" and
/// "right skirt"; left and right as one looks at the chair's front. It is slipped on from above.
///
/// Cut as B. V. Morrison, "Slip Covers for Furniture" (USDA Farmers' Bulletin 1879, 1941) has covers modelled
/// on the chair itself: a piece for each surface, seams along the chair's edges, boxing where a part is
/// thick, a skirt ("valance") that clears the floor. Ease and flare are the project's.
Garment draft_chair_cover(const ChairCoverStyle& style = {}, const ChairSize& chair = {});

}  // namespace toile::draft
