#pragma once

#include "core/draft/garment.h"
#include "core/draft/wearer.h"

namespace toile::draft {

/// Millimetres for a person of 1.68 m.
struct CircleDressStyle {
  double bust_ease = 45;
  double waist_ease = 25;
  double length = 620;  ///< of the skirt
};

/// A sleeveless dress: a fitted bodice with bust and waist darts ("bodice front", "bodice left back", "bodice
/// right back") over a full circle ("skirt front", half of it on the fold, "skirt left back", "skirt right
/// back"). The back's middle seam stands for the zip.
///
/// The bodice is bodice.h's block. A circle skirt's waist is an arc whose radius is its length over the
/// angle; front and back have their bodices' own, so that the hem is level.
Garment draft_circle_dress(const Wearer& wearer, const CircleDressStyle& style = {});

}  // namespace toile::draft
