#pragma once
// Darts that are only drawn: two lines from the outline to a point within the piece, across whose mouth the
// outline runs on. Drafting programs write most darts so; the cloth between the lines is sewn away.

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::create {

/// From one place of the outline to the tip and on to another, mm; the mouth runs from `first` to `second`
/// with the cloth at its left.
struct DrawnDart {
  Vec2 first, tip, second;
};

/// Darts among the lines of the piece that are only drawn: legs alike in length that end on the outline, or
/// beyond it where they go on into the allowance, and meet in a narrow point. A line in the middle of a dart
/// is none of its legs. REQUIRES a panel that validate() accepts.
std::vector<DrawnDart> drawn_darts(const pattern::Panel& panel);

/// The piece with the dart cut out of it: its legs are two edges, its lines are gone, and edges are
/// numbered anew.
pattern::Panel with_dart(const pattern::Panel& panel, const DrawnDart& dart);

}  // namespace toile::create
