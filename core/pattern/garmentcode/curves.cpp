#include "core/pattern/garmentcode/curves.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace toile::garmentcode {

pattern::CubicBezier cubic_from_quadratic(Vec2 a, Vec2 control, Vec2 b) {
  return {a, a + (control - a) * (2.0 / 3), b + (control - b) * (2.0 / 3), b};
}

std::vector<pattern::CubicBezier> cubics_from_arc(Vec2 a, Vec2 b, double radius, bool large,
                                                  bool counter_clockwise) {
  const Vec2 chord = b - a;
  const double half = length(chord) / 2;
  const double r = std::max(radius, half);
  // The centre is left of the chord for the short arc that turns left, and for the long one that turns right.
  const double side = large == counter_clockwise ? -1 : 1;
  const Vec2 centre = (a + b) * 0.5 + normalized(perpendicular(chord)) *
                                          (side * std::sqrt(std::max(0.0, r * r - half * half)));
  const double narrow = 2 * std::asin(std::min(1.0, half / r));
  const double sweep = (large ? 2 * kPi - narrow : narrow) * (counter_clockwise ? 1 : -1);
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (kPi / 4))));
  const double step = sweep / count, handle = 4.0 / 3 * std::tan(step / 4);
  const double start = std::atan2(a.y - centre.y, a.x - centre.x);
  const auto on_circle = [&](int i) {
    if (i == 0) return a;
    if (i == count) return b;
    return centre + Vec2{std::cos(start + i * step), std::sin(start + i * step)} * r;
  };
  std::vector<pattern::CubicBezier> curves;
  for (int i = 0; i < count; ++i) {
    const Vec2 p = on_circle(i), q = on_circle(i + 1);
    curves.push_back({p, p + perpendicular(p - centre) * handle, q - perpendicular(q - centre) * handle, q});
  }
  return curves;
}

}  // namespace toile::garmentcode
