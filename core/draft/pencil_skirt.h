#pragma once

#include "core/draft/garment.h"
#include "core/draft/wearer.h"

namespace toile::draft {

/// Millimetres for a person of 1.68 m.
struct PencilSkirtStyle {
  double waist_ease = 10;  ///< of the band
  double hip_ease = 50;
  double pegged = 15;  ///< each quarter of the hem is narrower than at the hips by so much
  double slit = 150;   ///< of the back's middle seam, left open
  double band_height = 35;
};

/// A narrow skirt of cloth to the knee: "front" on the fold, "left back", "right back" with a slit in their
/// middle seam, and a "waistband" that closes at the back's middle; one dart in each quarter.
///
/// The basic skirt block as Müller & Sohn and Aldrich draft it: what hips and waist differ by in a quarter is
/// shared between the side seam and a dart, more of it in the back's, and the back's dart is longer; the side
/// rises above the waist line's middle by about a centimetre. Shares and eases are the project's.
Garment draft_pencil_skirt(const Wearer& wearer, const PencilSkirtStyle& style = {});

}  // namespace toile::draft
