#pragma once
// Curves of the drawing as polylines in millimetres, chained end to end.

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/pattern/dxf_entities.h"
#include "core/pattern/dxf_read.h"

namespace toile {

/// x·a + y·b + origin.
struct DxfTransform {
  Vec2 x{1, 0}, y{0, 1}, origin;
  Vec2 operator()(Vec2 p) const { return p.x * x + p.y * y + origin; }
};

/// From the coordinates of a block to those of the drawing that inserts it.
DxfTransform transform_of(const DxfInsert& insert, const DxfBlock& block);

/// Joined curves of one layer. The first point of a closed chain is not repeated at its end.
struct DxfChain {
  std::vector<Vec2> points;  ///< mm
  bool closed = false;
  std::string layer;
  int line = 0;              ///< of its earliest entity
  std::vector<Vec2> breaks;  ///< where entities meet, when there are several
};

/// The curves of a block as chains, by line. `drawn` counts the points drawn so far over the whole drawing.
/// Errors: dxf.too_large, dxf.coordinate_range.
Result<std::vector<DxfChain>> chains_of(const DxfBlock& block, const DxfTransform& transform,
                                        double mm_per_unit, const DxfSettings& settings, std::size_t& drawn);

}  // namespace toile
