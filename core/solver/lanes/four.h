#pragma once
// Four doubles side by side, as GCC's vectors: what the kernels are written in. Included by lanes_plain.cpp
// and lanes_avx2.cpp alone, and all in an unnamed namespace, so that no code for one target ends up in the
// other.

#include <cmath>

#include "core/solver/lanes/lanes.h"

#define TOILE_INLINE inline __attribute__((always_inline))

namespace toile {
namespace {

typedef double Four __attribute__((vector_size(32)));
typedef float FourFloats __attribute__((vector_size(16)));
/// All bits of a lane, or none.
typedef std::int64_t FourFlags __attribute__((vector_size(32)));

struct Four3 {
  Four x, y, z;
};

constexpr Four kOne = {1, 1, 1, 1}, kNothing = {0, 0, 0, 0};

TOILE_INLINE Four load(const Lanes& l) {
  return __builtin_convertvector(*reinterpret_cast<const FourFloats*>(l.at), Four);
}
TOILE_INLINE bool any(FourFlags f) { return (f[0] | f[1] | f[2] | f[3]) != 0; }
TOILE_INLINE Four root(Four a) {
  return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
TOILE_INLINE Four larger(Four a, Four b) { return a > b ? a : b; }
TOILE_INLINE Four3 operator+(const Four3& a, const Four3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
TOILE_INLINE Four3 operator-(const Four3& a, const Four3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
TOILE_INLINE Four3 operator*(const Four3& a, Four s) { return {a.x * s, a.y * s, a.z * s}; }
TOILE_INLINE Four dot(const Four3& a, const Four3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

TOILE_INLINE Four3 choose(FourFlags first, const Four3& a, const Four3& b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

TOILE_INLINE Four3 gather(const Vec3* x, const Index (&v)[kLanes]) {
  const Vec3 &a = x[v[0]], &b = x[v[1]], &c = x[v[2]], &d = x[v[3]];
  return {Four{a.x, b.x, c.x, d.x}, Four{a.y, b.y, c.y, d.y}, Four{a.z, b.z, c.z, d.z}};
}

template <int kLane>
TOILE_INLINE void put(Vec3* x, const Index (&v)[kLanes], const Four3& p) {
  x[v[kLane]] = {p.x[kLane], p.y[kLane], p.z[kLane]};
}

/// Lane by lane with fixed numbers: a lane picked at run time would go through memory.
TOILE_INLINE void scatter(Vec3* x, const Index (&v)[kLanes], int count, const Four3& p) {
  put<0>(x, v, p);
  if (count > 1) put<1>(x, v, p);
  if (count > 2) put<2>(x, v, p);
  if (count > 3) put<3>(x, v, p);
}

}  // namespace
}  // namespace toile
