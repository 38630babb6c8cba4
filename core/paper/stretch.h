#pragma once
// Equation 5 of Kim and Park 2003: links that give up to a largest strain.

#include "core/base/types.h"

namespace toile::paper {

/// Two particles that an edge of the mesh joins.
struct Link {
  Index a = kNone, b = kNone;
  double rest = 0;   ///< m
  double limit = 0;  ///< ε_max, the largest elastic strain along the link; 1 is soft
};

/// Draws two particles together to the link's rest length if it is strained beyond its limit:
///
///     l = |x2 − x1|,  v = x2 − x1,  D = (l − l_rest) / (l·(1/m1 + 1/m2))
///     x1' = x1 + v·D/m1,  x2' = x2 − v·D/m2      where (l − l_rest)/l_rest > ε_max
///
/// In print x2' has a "+", with which both would drift along v; a pull together that leaves their common
/// centre of mass is meant. It goes all the way to l_rest, as D says, not to the limit. A link that is
/// pushed together is left alone, so cloth can buckle. `w1`, `w2`: 1/m (1/kg).
inline void pull_together(Vec3& x1, Vec3& x2, double w1, double w2, double rest, double limit) {
  const Vec3 v = x2 - x1;
  const double most = rest * (1 + limit), squared = dot(v, v);
  if (!(squared > most * most)) return;
  const double l = std::sqrt(squared);
  const double d = (l - rest) / (l * (w1 + w2));
  x1 += v * (d * w1);
  x2 -= v * (d * w2);
}

}  // namespace toile::paper
