#pragma once
// Numbers side by side: GCC's vectors and what is done with them, in one vocabulary for all rooms with hot
// loops. Only what compiles to one instruction or a few; each lane's result is what the plain operation
// gives, so code written with these gives the same bytes as a loop.

#include <cstdint>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

/// Kernels are compiled for several targets: what they call must not exist on its own, or the linker might
/// take one target's code for another's.
#define TOILE_INLINE inline __attribute__((always_inline))

namespace toile {

using Floats4 = float __attribute__((vector_size(16)));
using Doubles2 = double __attribute__((vector_size(16)));
using Doubles4 = double __attribute__((vector_size(32)));
/// All bits of a lane, or none: what comparisons of floats give.
using Flags4 = std::int32_t __attribute__((vector_size(16)));
using Flags8 = std::int32_t __attribute__((vector_size(32)));

/// A 3D vector in each lane.
template <typename V>
struct Vec3s {
  V x, y, z;
};
template <typename V>
TOILE_INLINE Vec3s<V> operator+(const Vec3s<V>& a, const Vec3s<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename V>
TOILE_INLINE Vec3s<V> operator-(const Vec3s<V>& a, const Vec3s<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename V>
TOILE_INLINE Vec3s<V> operator*(const Vec3s<V>& a, V s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <typename V>
TOILE_INLINE V dot(const Vec3s<V>& a, const Vec3s<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The four floats from `first` on.
TOILE_INLINE Floats4 floats_at(const float* first) {
  using Anywhere = float __attribute__((vector_size(16), aligned(4), may_alias));
  return *reinterpret_cast<const Anywhere*>(first);
}
TOILE_INLINE Floats4 four_of(float value) { return Floats4{value, value, value, value}; }

TOILE_INLINE void put(Floats4 four, float* first) {
  for (int i = 0; i < 4; ++i) first[i] = four[i];
}

/// The less, and the greater, of each lane: b where a is no number.
TOILE_INLINE Floats4 least(Floats4 a, Floats4 b) {
#if defined(__SSE__)
  return _mm_min_ps(a, b);
#else
  return a < b ? a : b;
#endif
}
TOILE_INLINE Floats4 most(Floats4 a, Floats4 b) {
#if defined(__SSE__)
  return _mm_max_ps(a, b);
#else
  return a > b ? a : b;
#endif
}

/// Bit i: lane i of `flags` is set.
TOILE_INLINE unsigned bits_of(Flags4 flags) {
#if defined(__SSE__)
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(flags)));
#else
  unsigned bits = 0;
  for (int i = 0; i < 4; ++i) bits |= static_cast<unsigned>(flags[i] != 0) << i;
  return bits;
#endif
}

}  // namespace toile
