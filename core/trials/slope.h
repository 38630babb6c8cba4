#pragma once
// The line that fits measured points best.

#include <span>

#include "core/base/types.h"

namespace toile::trials {

/// Slope of y over x by least squares. REQUIRES two points of different x.
inline double slope_of(std::span<const Vec2> points) {
  double n = 0, x = 0, xx = 0, y = 0, xy = 0;
  for (const Vec2& p : points) {
    n += 1;
    x += p.x;
    xx += p.x * p.x;
    y += p.y;
    xy += p.x * p.y;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace toile::trials
