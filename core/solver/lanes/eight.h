#pragma once
// Eight floats side by side, as GCC's vectors: what the kernels are written in. Included by lanes_plain.cpp
// and lanes_avx2.cpp alone, and all in an unnamed namespace, so that no code for one target ends up in the
// other.
//
// Positions are doubles. Their differences within a triangle are taken in double and then rounded: a float
// holds them to a few parts in 10⁸ of an edge, wherever in the room the cloth is.

#ifdef __SSE2__
#include <immintrin.h>
#else
#include <cmath>
#endif

#include "core/solver/lanes/lanes.h"

#define TOILE_INLINE inline __attribute__((always_inline))

namespace toile {
namespace {

typedef float Eight __attribute__((vector_size(32)));
typedef float FourFloats __attribute__((vector_size(16)));
typedef double FourDoubles __attribute__((vector_size(32)));
/// All bits of a lane, or none.
typedef std::int32_t EightFlags __attribute__((vector_size(32)));

struct Eight3 {
  Eight x, y, z;
};

constexpr Eight kOne = {1, 1, 1, 1, 1, 1, 1, 1}, kNothing = {0, 0, 0, 0, 0, 0, 0, 0};

TOILE_INLINE Eight load(const Lanes& l) { return *reinterpret_cast<const Eight*>(l.at); }
TOILE_INLINE bool any(EightFlags f) {
#ifdef __AVX__
  return _mm256_movemask_ps(reinterpret_cast<__m256>(f)) != 0;
#else
  return ((f[0] | f[1]) | (f[2] | f[3]) | (f[4] | f[5]) | (f[6] | f[7])) != 0;
#endif
}
/// Rounded correctly everywhere.
TOILE_INLINE Eight root(Eight a) {
#ifdef __AVX__
  return _mm256_sqrt_ps(a);
#elif defined(__SSE2__)
  const FourFloats low = _mm_sqrt_ps(__builtin_shufflevector(a, a, 0, 1, 2, 3));
  const FourFloats high = _mm_sqrt_ps(__builtin_shufflevector(a, a, 4, 5, 6, 7));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  for (int i = 0; i < kLanes; ++i) a[i] = std::sqrt(a[i]);
  return a;
#endif
}
TOILE_INLINE Eight larger(Eight a, Eight b) { return a > b ? a : b; }
TOILE_INLINE Eight3 operator+(const Eight3& a, const Eight3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
TOILE_INLINE Eight3 operator-(const Eight3& a, const Eight3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
TOILE_INLINE Eight3 operator*(const Eight3& a, Eight s) { return {a.x * s, a.y * s, a.z * s}; }
TOILE_INLINE Eight dot(const Eight3& a, const Eight3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// GCC 12 takes conversions between four floats and four doubles apart; as instructions they are one each.
TOILE_INLINE FourFloats single(FourDoubles a) {
#ifdef __AVX__
  return _mm256_cvtpd_ps(a);
#else
  return __builtin_convertvector(a, FourFloats);
#endif
}
TOILE_INLINE FourDoubles twice_as_long(FourFloats a) {
#ifdef __AVX__
  return _mm256_cvtps_pd(a);
#else
  return __builtin_convertvector(a, FourDoubles);
#endif
}

TOILE_INLINE FourDoubles& at(LanePoint* x, LaneOffset v) {
  return *reinterpret_cast<FourDoubles*>(reinterpret_cast<char*>(x) + v);
}
TOILE_INLINE FourFloats difference(LanePoint* x, LaneOffset to, LaneOffset from) {
  return single(at(x, to) - at(x, from));
}

/// Ways from one vertex of each lane to another (m).
TOILE_INLINE Eight3 ways(LanePoint* x, const LaneOffset (&from)[kLanes], const LaneOffset (&to)[kLanes]) {
  const auto two = [&](int lane) {  // this lane's and that of the upper half
    return __builtin_shufflevector(difference(x, to[lane], from[lane]),
                                   difference(x, to[lane + 4], from[lane + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Eight a = two(0), b = two(1), c = two(2), d = two(3);
  const Eight xy01 = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const Eight xy23 = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
  const Eight z01 = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  const Eight z23 = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  return {__builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15),
          __builtin_shufflevector(z01, z23, 0, 1, 8, 9, 4, 5, 12, 13)};
}

/// Moves a vertex of each lane by `d`, lane after lane: lanes may name one vertex twice.
TOILE_INLINE void move(LanePoint* x, const LaneOffset (&v)[kLanes], const Eight3& d) {
  const Eight xy02 = __builtin_shufflevector(d.x, d.y, 0, 8, 1, 9, 4, 12, 5, 13);
  const Eight xy13 = __builtin_shufflevector(d.x, d.y, 2, 10, 3, 11, 6, 14, 7, 15);
  const Eight z02 = __builtin_shufflevector(d.z, kNothing, 0, 8, 1, 9, 4, 12, 5, 13);
  const Eight z13 = __builtin_shufflevector(d.z, kNothing, 2, 10, 3, 11, 6, 14, 7, 15);
  const Eight lanes[4] = {__builtin_shufflevector(xy02, z02, 0, 1, 8, 9, 4, 5, 12, 13),
                          __builtin_shufflevector(xy02, z02, 2, 3, 10, 11, 6, 7, 14, 15),
                          __builtin_shufflevector(xy13, z13, 0, 1, 8, 9, 4, 5, 12, 13),
                          __builtin_shufflevector(xy13, z13, 2, 3, 10, 11, 6, 7, 14, 15)};
  for (int i = 0; i < 4; ++i) {
    at(x, v[i]) += twice_as_long(__builtin_shufflevector(lanes[i], lanes[i], 0, 1, 2, 3));
    at(x, v[i + 4]) += twice_as_long(__builtin_shufflevector(lanes[i], lanes[i], 4, 5, 6, 7));
  }
}

}  // namespace
}  // namespace toile
