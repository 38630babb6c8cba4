#pragma once
// Arcs of circles as an outline's edges.

#include <string>

#include "core/base/units.h"
#include "core/draft/outline.h"

namespace toile::draft {

/// One cubic's share of an arc: off by 1e-7 of the radius.
inline constexpr double kMostPerCurve = kPi / 8;

/// An edge along the circle about `centre`, from the angle `from` to `to` (radians, counter-clockwise where
/// it rises). REQUIRES that the outline stands where the arc begins.
void add_arc(Outline& outline, const std::string& edge, Vec2 centre, double radius, double from, double to);

/// A sector of a ring whose apex is at the origin, symmetrical about the way down (-y): edges hem, the side
/// `plus` at x > 0 going up, waist, the side `minus`. mm, radians.
pattern::Panel ring_sector(const std::string& id, double inner, double outer, double angle,
                           const std::string& plus, const std::string& minus);

}  // namespace toile::draft
