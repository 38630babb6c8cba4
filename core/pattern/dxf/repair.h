#pragma once
// Small faults that drawing programs leave in outlines.

#include <vector>

#include "core/base/types.h"

namespace toile::dxf {

struct RepairedOutline {
  std::vector<Vec2> points;
  std::vector<Vec2> cut_at;  ///< where the faults were
};

/// The closed outline without the tips on which it turns back within 0.1 mm, or along itself: digitisers and
/// joined curves leave them. Curves fitted through them would cross.
RepairedOutline without_backtracks(const std::vector<Vec2>& outline);

/// The closed outline without the small loops that it makes where it crosses itself: less than 5 mm and a
/// fiftieth of the whole around. At most 50 are cut off; what crosses in earnest stays.
RepairedOutline without_small_loops(const std::vector<Vec2>& outline);

}  // namespace toile::dxf
