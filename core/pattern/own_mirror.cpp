#include "core/pattern/own_mirror.h"

#include <cmath>

namespace toile::pattern {

bool is_own_mirror(const Loop& loop) {
  constexpr double kSame = 0.5;  // mm
  const std::size_t n = loop.edges.size();
  const auto corner = [&](std::size_t k) { return loop.edges[k % n].curves.front().p0; };
  const auto differ = [&](std::size_t k, std::size_t other) {
    const auto far = [](double a, double b) { return std::abs(a - b) > kSame; };
    return far(arc_length(loop.edges[k]), arc_length(loop.edges[other])) ||
           far(length(corner(k + 1) - corner(k)), length(corner(other + 1) - corner(other))) ||
           far(length(corner(k + 2) - corner(k)), length(corner(other + 1) - corner(other + n - 1)));
  };
  for (std::size_t shift = 0; shift < n; ++shift) {
    bool same = true;
    for (std::size_t k = 0; k < n && same; ++k) same = !differ(k, (shift + n - k) % n);
    if (same) return true;
  }
  return false;
}

}  // namespace toile::pattern
