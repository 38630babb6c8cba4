#include "core/solver/constraints/button.h"

#include <algorithm>

namespace toile::solver::constraints {

namespace {

double mobility_of(const sewing::ClothPoint& point, std::span<const double> w) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += w[point.v[i]] * point.share[i] * point.share[i];
  return sum;
}

void pull(const sewing::ClothPoint& point, Vec3 impulse, std::span<const double> w, std::span<Vec3> x) {
  for (int i = 0; i < 3; ++i) x[point.v[i]] += impulse * (point.share[i] * w[point.v[i]]);
}

}  // namespace

void solve_ties(std::span<const PointTie> ties, double open, std::span<const double> w, double h,
                std::span<Vec3> x) {
  for (const PointTie& tie : ties) {
    const Vec3 d = sewing::position_of(tie.b, x) - sewing::position_of(tie.a, x);
    const double l = length(d);
    const double allowed = tie.end_length + std::max(0.0, tie.start_length - tie.end_length) * open;
    const double mobility = mobility_of(tie.a, w) + mobility_of(tie.b, w);
    if (l <= allowed || l <= 0 || mobility <= 0) continue;
    const double excess = l - allowed;
    const double force = excess > kTieClosed ? tie.closing_force : tie.holding_force;
    const double lambda = std::min(std::min(excess, kTieSpeed * h) / mobility, force * h * h);
    const Vec3 impulse = d * (lambda / l);
    pull(tie.a, impulse, w, x);
    pull(tie.b, -impulse, w, x);
  }
}

OpenTie widest_tie(std::span<const PointTie> ties, std::span<const Vec3> x) {
  OpenTie widest;
  for (std::size_t i = 0; i < ties.size(); ++i) {
    const double excess =
        length(sewing::position_of(ties[i].b, x) - sewing::position_of(ties[i].a, x)) - ties[i].end_length;
    if (excess > widest.excess) widest = {static_cast<Index>(i), excess};
  }
  return widest;
}

}  // namespace toile::solver::constraints
