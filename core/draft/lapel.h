#pragma once
// Lapels and the collar that goes with them, drafted together on the line along which both roll.

#include <string>

#include "core/draft/outline.h"

namespace toile::draft {

/// What is told; mm, the front's frame (x from the middle to the wearer's side, y up).
struct LapelDraft {
  Vec2 neck, shoulder;           ///< ends of the front's shoulder
  Vec2 break_point;              ///< where the lapel begins to roll, on the front's edge
  double back_neck = 85;         ///< half the length of the back's neckline
  double stand = 28, fall = 44;  ///< of the collar at the middle of the back
  double gorge_below = 58;       ///< the gorge crosses the roll line so far below the shoulder
  double gorge_slope = 8;        ///< degrees that it falls outwards by, off the square to the roll line
  double width = 84;             ///< of the lapel along the gorge
  double notch = 42;             ///< from the roll line to where the collar begins
  double collar_end = 36;        ///< length of the collar's front end
  double spread = 42;            ///< degrees that the back part is swung by, so that the fall is wide enough
};

/// Points of the front and of the collar, lapel and collar unrolled.
struct Lapel {
  Vec2 gorge_inner;                   ///< where gorge and neckline meet
  Vec2 roll_top;                      ///< where the roll line crosses the gorge
  Vec2 notch;                         ///< where lapel and collar part
  Vec2 tip;                           ///< of the lapel
  Vec2 edge_handle, edge_low_handle;  ///< of the lapel's outer edge, from tip to break point
};

/// After Aldrich's "collar and rever" (Metric Pattern Cutting for Women's Wear, from memory): the roll line
/// runs from the break point to three quarters of the stand beyond the neck on the shoulder's line; lapel and
/// collar are drawn on the body as they shall lie and mirrored about it; the gorge goes on to a line through
/// the neck along the roll line; the collar shares it, and its back part is swung outwards about the neck.
Lapel lapel_of(const LapelDraft& draft);

/// From the neck down the neckline, out along the gorge and around the lapel to the break point: edges
/// front_neck, gorge_inner, gorge_outer, lapel_top, lapel. REQUIRES that the outline stands at draft.neck.
void add_lapel(Outline& outline, const LapelDraft& draft);
/// The line on the front along which the lapel rolls: "roll".
pattern::InnerLine lapel_roll(const LapelDraft& draft);

/// The whole collar, stand and fall in one, its middle at x = 0, the neck's edge below: edges neck, and of
/// each side ("_right", "_left" as worn) front_neck, gorge_inner, gorge_outer, end; top. The inner line
/// "roll" goes on where the lapels' end.
pattern::Panel collar_of(const std::string& id, const LapelDraft& draft);

}  // namespace toile::draft
