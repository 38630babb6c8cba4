#pragma once
// Pockets' facings on which the line of the mouth is drawn: they tell what a front lacks.

#include <optional>
#include <span>
#include <vector>

#include "core/pattern/pattern.h"
#include "core/pattern/seams/model.h"

namespace toile::create {

/// A front's edge at a pocket, or the part of its side that is cut there, and where side and waist would
/// meet, mm.
struct PocketCorner {
  Index panel = kNone, mouth = kNone;
  Vec2 corner;
  double from = 0, to = 1;  ///< shares of the edge's length
};

/// Where the front's side runs into a mouth without a corner: the line of the mouth that is drawn on a facing
/// tells how long the mouth is, and the facing's corner beyond it lies where side and waist go on to, and
/// makes the side as long as one of those `behind`.
std::optional<PocketCorner> corner_by_facing(std::span<const pattern::Panel> panels,
                                             const seams::SeamModel& model, Index panel,
                                             const std::vector<double>& behind);

/// Where corners may be that facings add to a mouth that goes straight from the side's end to the waist's,
/// mm: on a facing a line as long as that is drawn, and seen from there a corner lies where side and waist go
/// on to. `after`: the outline runs from the side to the waist.
std::vector<Vec2> facing_corners_at(std::span<const pattern::Panel> panels, const seams::SeamModel& model,
                                    const pattern::PanelEdge& side, const pattern::PanelEdge& waist,
                                    bool after);

}  // namespace toile::create
