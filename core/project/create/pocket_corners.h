#pragma once
// Fronts of trousers that are drawn without their corner at side and waist: the mouth of a pocket is cut
// there, and the pocket's facing, which lies under it, is what goes on to the side and to the waistband.

#include <span>
#include <vector>

#include "core/project/create/pocket_facings.h"

namespace toile::create {

/// Where another piece is a facing or a pocket by its name, and a back's side, alone or with a yoke's, is as
/// long as the front's would be with the corner, and not without it. The line of the mouth that is drawn on
/// the facing tells where it is, and also where the side runs into the mouth without a corner; else side and
/// waist run on straight to it. Grains point upwards.
std::vector<PocketCorner> pocket_corners(std::span<const pattern::Panel> panels);

/// The front with its corner: its side and its waist go on, and the mouth is gone.
pattern::Panel with_corner(const pattern::Panel& front, const PocketCorner& pocket);

}  // namespace toile::create
