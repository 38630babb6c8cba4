#include "core/solver/constraints/stitch.h"

#include <algorithm>

namespace toile {

void solve_stitches(std::span<const Stitch> stitches, double shrunk, std::span<const double> w, double h,
                    std::span<Vec3> x) {
  for (const Stitch& s : stitches) {
    const double w0 = w[s.v0], w1 = w[s.v1];
    const Vec3 d = x[s.v1] - x[s.v0];
    const double l = length(d), excess = l - shrunk * s.start_length;
    if (excess <= 0 || l <= 0 || w0 + w1 <= 0) continue;
    const double lambda = std::min(excess / (w0 + w1), s.force_limit * h * h);
    const Vec3 pull = d * (lambda / l);
    x[s.v0] += pull * w0;
    x[s.v1] -= pull * w1;
  }
}

double largest_gap(std::span<const Stitch> stitches, std::span<const Vec3> x) {
  double gap = 0;
  for (const Stitch& s : stitches) gap = std::max(gap, length(x[s.v1] - x[s.v0]));
  return gap;
}

}  // namespace toile
