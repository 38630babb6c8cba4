#include "core/solver/constraints/elastic.h"

#include "core/solver/one_pass.h"

namespace toile::solver::constraints {

void solve_elastics(std::span<const ElasticSegment> segments, double drawn, std::span<const double> w,
                    double h, std::span<Vec3> x) {
  for (const ElasticSegment& s : segments) {
    const double w0 = w[s.v0], w1 = w[s.v1], mobility = w0 + w1;
    const double rest = s.flat_length + (s.rest_length - s.flat_length) * drawn;
    const Vec3 d = x[s.v1] - x[s.v0];
    const double l = length(d);
    if (l <= rest || mobility <= 0) continue;
    const double soft = rest / (s.stiffness * h * h);
    const Vec3 pull = d * ((l - rest) / ((soft + one_pass_share(soft, mobility) * mobility) * l));
    x[s.v0] += pull * w0;
    x[s.v1] -= pull * w1;
  }
}

}  // namespace toile::solver::constraints
