#pragma once
// Fronts of trousers that are drawn without their corner at side and waist: the mouth of a pocket is cut
// there, and the pocket's facing, which lies under it, is what goes on to the side and to the waistband.

#include <span>
#include <vector>

#include "core/pattern/pattern.h"

namespace toile::create {

/// A front's edge at a pocket, and where side and waist meet that run on straight beyond its ends, mm.
struct PocketCorner {
  Index panel = kNone, mouth = kNone;
  Vec2 corner;
};

/// Where another piece is a facing or a pocket by its name, and a back's side, alone or with a yoke's, is as
/// long as the front's would be with the corner, and not without it. Grains point upwards.
std::vector<PocketCorner> pocket_corners(std::span<const pattern::Panel> panels);

/// The front with its corner: its side and its waist go on, the mouth is no edge.
pattern::Panel with_corner(const pattern::Panel& front, const PocketCorner& pocket);

}  // namespace toile::create
