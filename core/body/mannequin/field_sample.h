#pragma once

#include <functional>

#include "core/base/types.h"

namespace toile::mannequin {

/// An implicit surface at a point: `value` is negative inside and close to the distance near the surface.
struct FieldSample {
  double value = 0;
  Vec3 gradient;
};

/// A point on such a surface.
struct SurfacePoint {
  Vec3 position;
  Vec3 normal;         ///< unit, outwards
  bool found = false;  ///< whether the steps arrived
};

using ImplicitSurface = std::function<FieldSample(Vec3)>;

}  // namespace toile::mannequin
