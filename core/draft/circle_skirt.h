#pragma once

#include "core/draft/garment.h"
#include "core/draft/wearer.h"

namespace toile::draft {

/// Millimetres for a person of 1.68 m.
struct CircleSkirtStyle {
  double waist_ease = 10;  ///< of the band
  double length = 520;     ///< below the band
  double band_height = 35;
};

/// A full circle on a band: "front" and "back", a half of a ring each, and a "waistband" that closes at the
/// wearer's right. What hangs freely all around shows more than any other skirt what a cloth is like.
///
/// The circle skirt of every pattern book: the waist line is a circle as long as the band, so its radius is
/// the band's length over 2π, and the hem lies the skirt's length farther out. Ease and length are the
/// project's.
Garment draft_circle_skirt(const Wearer& wearer, const CircleSkirtStyle& style = {});

}  // namespace toile::draft
