#include "core/collision/near_edges.h"

#include "core/base/simd.h"

namespace toile::collision {

namespace {

using Two = Doubles2;
using TwoFlags = decltype(Two{} < Two{});
using Two3 = Vec3s<Two>;

Two3 beside(Vec3 a, Vec3 b) { return {Two{a.x, b.x}, Two{a.y, b.y}, Two{a.z, b.z}}; }
Two unit_range(Two x) {
  const Two none{}, one = none + 1;
  x = x < none ? none : x;
  return x > one ? one : x;
}

/// The filter may round otherwise than the measure that follows: so much, of the squared gap, is left to it.
constexpr double kRounding = 1 + 1e-9;

}  // namespace

EdgeLine edge_line(Vec3 from, Vec3 to, double reach) {
  const Vec3 way = to - from;
  return {from, way, dot(way, way), reach};
}

unsigned near_ones(const EdgeLine* const (&a)[2], const EdgeLine* const (&b)[2]) {
  const Two3 r = beside(a[0]->start, a[1]->start) - beside(b[0]->start, b[1]->start);
  const Two3 u = beside(a[0]->way, a[1]->way), v = beside(b[0]->way, b[1]->way);
  const Two uu{a[0]->squared, a[1]->squared}, vv{b[0]->squared, b[1]->squared};
  const Two reach{a[0]->reach + b[0]->reach, a[1]->reach + b[1]->reach};
  const Two none{}, one = none + 1, half = none + 0.5;

  const Two uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
  const Two slant = uu * vv - uv * uv;
  Two s = slant > 1e-12 * uu * vv ? unit_range((uv * vr - ur * vv) / slant) : half;
  const Two t = (uv * s + vr) / vv;
  const Two ends = t < none ? -ur : uv - ur;  // where s must go when t is cut to an end
  s = (t < none) | (t > one) ? unit_range(ends / uu) : s;
  const Two cut = unit_range(t);
  const Two3 d{r.x + u.x * s - v.x * cut, r.y + u.y * s - v.y * cut, r.z + u.z * s - v.z * cut};
  const TwoFlags far = dot(d, d) > reach * reach * kRounding;  // an edge without length: never far
  return static_cast<unsigned>(far[0] == 0) | static_cast<unsigned>(far[1] == 0) << 1;
}

}  // namespace toile::collision
