#include "core/draft/arc.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace toile::draft {
namespace {

Vec2 on_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

void add_arc(Outline& outline, const std::string& edge, Vec2 centre, double radius, double from, double to) {
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / kMostPerCurve)));
  for (int i = 0; i < parts; ++i) {
    const double a = from + (to - from) * i / parts, b = from + (to - from) * (i + 1) / parts;
    const double handle = radius * 4 / 3 * std::tan((b - a) / 4);
    const Vec2 end = centre + on_circle(b) * radius;
    const Vec2 one = outline.at() + perpendicular(on_circle(a)) * handle;
    const Vec2 other = end - perpendicular(on_circle(b)) * handle;
    i == 0 ? outline.curve(edge, one, other, end) : outline.curve(one, other, end);
  }
}

pattern::Panel ring_sector(const std::string& id, double inner, double outer, double angle,
                           const std::string& plus, const std::string& minus) {
  const double low = -kPi / 2 - angle / 2, high = -kPi / 2 + angle / 2;
  Outline out(on_circle(low) * outer);
  add_arc(out, "hem", {}, outer, low, high);
  out.line(plus, on_circle(high) * inner);
  add_arc(out, "waist", {}, inner, high, low);
  out.line(minus, on_circle(low) * outer);
  return piece(id, out);
}

}  // namespace toile::draft
