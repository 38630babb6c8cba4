#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/geometry/triangle_mesh.h"

namespace toile::draft {

/// m.
struct Box {
  Vec3 low, high;
};

/// What boxes whose sides touch or overlap are together: closed, with nothing left within, its faces cut into
/// rectangles of at most `step`, m. REQUIRES that no two of them meet in an edge or a corner alone.
geometry::TriangleMesh joined_boxes(const std::vector<Box>& boxes, double step);

}  // namespace toile::draft
