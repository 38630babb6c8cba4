#pragma once

#include "core/draft/garment.h"
#include "core/draft/wearer.h"

namespace toile::draft {

/// Millimetres for a person of 1.68 m.
struct JacketStyle {
  double bust_ease = 110, waist_ease = 90, hip_ease = 80;
  double longer = 26;  ///< from the nape to the waist than the body
  double below_hip = 30;
  double break_above_waist = 55;  ///< where the lapels begin to roll
  double closed = 95;             ///< of the front's edge below the break point
  double sleeve_hem = 270;
  double stand = 25, fall = 50;  ///< of the collar
  double lapel = 86;             ///< width
};

/// A tailored jacket, closed edge to edge: of each side "front" with its lapel, "side front", "back", "side
/// back", "top sleeve" and "under sleeve", and "collar", 13 pieces. Fronts and collar are fused with
/// interlining.
///
/// From bodice.h's block with a jacket's ease, cut by princess.h's seams; lapel.h's collar and lapels;
/// two_piece_sleeve.h's sleeves.
Garment draft_jacket(const Wearer& wearer, const JacketStyle& style = {});

}  // namespace toile::draft
