#pragma once
// Eight lanes a register, for AVX2 and, in halves, for every x86-64. Part of wide.h.

#ifdef __SSE2__
#include <immintrin.h>
#else
#include <cmath>
#endif

namespace toile::solver::lanes {
namespace {

using WideFlags = Flags8;

TOILE_INLINE WideFlags above(Wide a, Wide b) { return a > b; }
TOILE_INLINE Wide either(WideFlags f, Wide a, Wide b) { return f ? a : b; }
TOILE_INLINE bool any(WideFlags f) {
#ifdef __AVX__
  return _mm256_movemask_ps(reinterpret_cast<__m256>(f)) != 0;
#else
  return ((f[0] | f[1]) | (f[2] | f[3]) | (f[4] | f[5]) | (f[6] | f[7])) != 0;
#endif
}
/// Rounded correctly everywhere.
TOILE_INLINE Wide root(Wide a) {
#ifdef __AVX__
  return _mm256_sqrt_ps(a);
#elif defined(__SSE2__)
  const Floats4 low = _mm_sqrt_ps(__builtin_shufflevector(a, a, 0, 1, 2, 3));
  const Floats4 high = _mm_sqrt_ps(__builtin_shufflevector(a, a, 4, 5, 6, 7));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  for (int i = 0; i < 8; ++i) a[i] = std::sqrt(a[i]);
  return a;
#endif
}

// GCC 12 takes conversions between four floats and four doubles apart; as instructions they are one each.
TOILE_INLINE Floats4 single(Doubles4 a) {
#ifdef __AVX__
  return _mm256_cvtpd_ps(a);
#else
  return __builtin_convertvector(a, Floats4);
#endif
}
TOILE_INLINE Doubles4 twice_as_long(Floats4 a) {
#ifdef __AVX__
  return _mm256_cvtps_pd(a);
#else
  return __builtin_convertvector(a, Doubles4);
#endif
}

TOILE_INLINE Doubles4& at(LanePoint* x, LaneOffset v) {
  return *reinterpret_cast<Doubles4*>(reinterpret_cast<char*>(x) + v);
}
TOILE_INLINE Floats4 difference(LanePoint* x, LaneOffset to, LaneOffset from) {
  return single(at(x, to) - at(x, from));
}

/// Ways from one vertex of each lane to another (m).
TOILE_INLINE Wide3 ways(LanePoint* x, const LaneOffset* from, const LaneOffset* to) {
  const auto two = [&](int lane) {  // this lane's and that of the upper half
    return __builtin_shufflevector(difference(x, to[lane], from[lane]),
                                   difference(x, to[lane + 4], from[lane + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Wide a = two(0), b = two(1), c = two(2), d = two(3);
  const Wide xy01 = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const Wide xy23 = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
  const Wide z01 = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  const Wide z23 = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  return {__builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15),
          __builtin_shufflevector(z01, z23, 0, 1, 8, 9, 4, 5, 12, 13)};
}

/// Moves a vertex of each lane by `d`, lane after lane.
TOILE_INLINE void move(LanePoint* x, const LaneOffset* v, const Wide3& d) {
  const Wide xy02 = __builtin_shufflevector(d.x, d.y, 0, 8, 1, 9, 4, 12, 5, 13);
  const Wide xy13 = __builtin_shufflevector(d.x, d.y, 2, 10, 3, 11, 6, 14, 7, 15);
  const Wide z02 = __builtin_shufflevector(d.z, kNothing, 0, 8, 1, 9, 4, 12, 5, 13);
  const Wide z13 = __builtin_shufflevector(d.z, kNothing, 2, 10, 3, 11, 6, 14, 7, 15);
  const Wide lanes[4] = {__builtin_shufflevector(xy02, z02, 0, 1, 8, 9, 4, 5, 12, 13),
                         __builtin_shufflevector(xy02, z02, 2, 3, 10, 11, 6, 7, 14, 15),
                         __builtin_shufflevector(xy13, z13, 0, 1, 8, 9, 4, 5, 12, 13),
                         __builtin_shufflevector(xy13, z13, 2, 3, 10, 11, 6, 7, 14, 15)};
  for (int i = 0; i < 4; ++i) {
    at(x, v[i]) += twice_as_long(__builtin_shufflevector(lanes[i], lanes[i], 0, 1, 2, 3));
    at(x, v[i + 4]) += twice_as_long(__builtin_shufflevector(lanes[i], lanes[i], 4, 5, 6, 7));
  }
}

}  // namespace
}  // namespace toile::solver::lanes
