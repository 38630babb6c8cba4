#pragma once
// Edges of GarmentCode's specifications as cubic Béziers.

#include <vector>

#include "core/base/types.h"
#include "core/pattern/pattern.h"

namespace toile::garmentcode {

/// The quadratic curve from a to b with one control point, as a cubic.
pattern::CubicBezier cubic_from_quadratic(Vec2 a, Vec2 control, Vec2 b);

/// The circular arc from a to b as cubics of at most 45° each (within 3e-6 of the radius). A radius under
/// half the chord becomes half the chord, as SVG has it. REQUIRES a != b, radius > 0.
std::vector<pattern::CubicBezier> cubics_from_arc(Vec2 a, Vec2 b, double radius, bool large,
                                                  bool counter_clockwise);

/// The point that lies `relative.x` of the edge's length along it and `relative.y` of it to its left.
constexpr Vec2 relative_to_edge(Vec2 a, Vec2 b, Vec2 relative) {
  return a + (b - a) * relative.x + perpendicular(b - a) * relative.y;
}

}  // namespace toile::garmentcode
