#pragma once
// Floats side by side, as GCC's vectors: what the kernels are written in. How many is the target's: eight.h
// and sixteen.h hold what differs. Included by lanes_plain.cpp, lanes_avx2.cpp and lanes_avx512.cpp alone,
// and all in an unnamed namespace, so that no code for one target ends up in another.
//
// Positions are doubles. Their differences within a triangle are taken in double and then rounded: a float
// holds them to a few parts in 10⁸ of an edge, wherever in the room the cloth is.

#include "core/base/simd.h"
#include "core/solver/lanes/lanes.h"

namespace toile::solver::lanes {
namespace {

/// Lanes of a pack that are solved at a time, one part of it after the other.
#ifdef __AVX512F__
constexpr int kWide = 16;
#else
constexpr int kWide = 8;
#endif
static_assert(kLanes % kWide == 0);

typedef float Wide __attribute__((vector_size(sizeof(float) * kWide)));

using Wide3 = Vec3s<Wide>;

constexpr Wide kNothing = {}, kOne = kNothing + 1;

}  // namespace
}  // namespace toile::solver::lanes

#ifdef __AVX512F__
#include "core/solver/lanes/sixteen.h"
#else
#include "core/solver/lanes/eight.h"
#endif

namespace toile::solver::lanes {
namespace {

TOILE_INLINE WideFlags above(Wide a, float b) { return above(a, kOne * b); }
TOILE_INLINE Wide larger(Wide a, Wide b) { return either(above(a, b), a, b); }
TOILE_INLINE Wide magnitude(Wide a) { return either(above(kNothing, a), -a, a); }

/// Reads a pack's coefficients from lane `first` on.
struct LaneReader {
  int first = 0;
  TOILE_INLINE Wide operator()(const Lanes& l) const { return *reinterpret_cast<const Wide*>(l.at + first); }
  TOILE_INLINE Wide& operator()(Lanes& l) const { return *reinterpret_cast<Wide*>(l.at + first); }
  TOILE_INLINE const LaneOffset* operator()(const LaneOffset (&v)[kLanes]) const { return v + first; }
};

}  // namespace
}  // namespace toile::solver::lanes
