#include "core/pattern/own_mirror.h"

#include <cmath>
#include <cstddef>

#include "core/pattern/curve.h"

namespace toile::pattern {

std::vector<Vec2> mirror_axes(const Loop& loop) {
  constexpr double kSame = 0.5;  // mm
  const std::size_t n = loop.edges.size();
  const auto corner = [&](std::size_t k) { return loop.edges[k % n].curves.front().p0; };
  const auto differ = [&](std::size_t k, std::size_t other) {
    const auto far = [](double a, double b) { return std::abs(a - b) > kSame; };
    return far(arc_length(loop.edges[k]), arc_length(loop.edges[other])) ||
           far(length(corner(k + 1) - corner(k)), length(corner(other + 1) - corner(other))) ||
           far(length(corner(k + 2) - corner(k)), length(corner(other + 1) - corner(other + n - 1)));
  };
  std::vector<Vec2> axes;
  for (std::size_t shift = 0; shift < n; ++shift) {
    bool same = true;
    Vec2 across;  // between the two corners of a pair that are farthest from each other
    for (std::size_t k = 0; k < n && same; ++k) {
      const std::size_t other = (shift + n - k) % n;
      same = !differ(k, other);
      const Vec2 pair = corner(k) - corner(other + 1);
      if (dot(pair, pair) > dot(across, across)) across = pair;
    }
    if (same && length(across) > kSame) axes.push_back(normalized(perpendicular(across)));
  }
  return axes;
}

bool is_own_mirror(const Loop& loop) { return !mirror_axes(loop).empty(); }

}  // namespace toile::pattern
