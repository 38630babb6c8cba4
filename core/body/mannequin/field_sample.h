#pragma once

#include <algorithm>
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

/// From 0 at `low` to 1 at `high`, level beyond both.
inline double smooth_step(double low, double high, double x) {
  const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

using ImplicitSurface = std::function<FieldSample(Vec3)>;

}  // namespace toile::mannequin
