#pragma once
// Elastic bands along edges and lines of the cloth: shorter than the cloth that they are sewn to, they gather
// it.

#include <span>

#include "core/base/types.h"

namespace toile::solver::constraints {

/// A piece of a band between two neighbouring vertices.
struct ElasticSegment {
  Index v0 = kNone, v1 = kNone;  ///< vertices of the solver
  double flat_length = 0;        ///< m, of the cloth along it
  double rest_length = 0;        ///< m, of the band without load
  double stiffness = 0;          ///< N per strain of the band
};

/// One pass of compliant bands (XPBD) that pull with stiffness·(length / rest − 1) and never push. `drawn`: 0
/// while the band rests at the cloth's length, 1 when it has come to its own.
void solve_elastics(std::span<const ElasticSegment> segments, double drawn, std::span<const double> w,
                    double h, std::span<Vec3> x);

}  // namespace toile::solver::constraints
