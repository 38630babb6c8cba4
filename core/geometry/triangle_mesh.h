#pragma once

#include <vector>

#include "core/base/types.h"

namespace toile::geometry {

/// A triangle surface in space. Metres, y up, right-handed.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<Tri> triangles;
};

}  // namespace toile::geometry
