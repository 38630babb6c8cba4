#pragma once
// Curves of a DXF drawing as points.

#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/dxf/entities.h"

namespace toile::dxf {

/// A curve drawn out as points.
struct DxfDrawn {
  std::vector<Vec2> points;  ///< mm, before any transform; the first of a closed one is not repeated
  std::size_t cost = 0;      ///< how much it takes from the room for points
};

/// Draws the curve out with at most `room` points. Error: dxf.too_large.
Result<DxfDrawn> drawn_out(const DxfCurve& curve, double mm_per_unit, const DxfSettings& settings,
                           std::size_t room);

}  // namespace toile::dxf
