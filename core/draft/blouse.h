#pragma once

#include "core/draft/garment.h"
#include "core/draft/wearer.h"

namespace toile::draft {

/// Millimetres for a person of 1.68 m.
struct BlouseStyle {
  double bust_ease = 100;
  double hip_ease = 110;
  double waist_in = 12;  ///< each quarter is narrower at the waist than under the arm, if the waist allows
  double below_hip = 40;
  double placket = 30;           ///< width
  double stand = 30, fall = 42;  ///< of the collar in the middle of the back
  double cuff = 60, cuff_ease = 45;
  double fullness = 1.35;  ///< of the sleeve's hem, gathered into the cuff
};

/// A blouse of cloth: "left front", "right front" with bust darts, "back", "placket" (worn closed: it is sewn
/// to both fronts), "collar stand", "collar" (its fall, turned down along their seam), "left sleeve", "right
/// sleeve", "left cuff", "right cuff".
///
/// From bodice.h's block with more ease, as Aldrich has her shirt block: a deeper armhole, a shallower cap
/// than a fitted sleeve's.
Garment draft_blouse(const Wearer& wearer, const BlouseStyle& style = {});

}  // namespace toile::draft
