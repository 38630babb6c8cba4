#pragma once
// Sixteen lanes a register, for AVX-512. Part of wide.h.

#include <immintrin.h>

namespace toile::solver::lanes {
namespace {

/// A bit a lane: flags as vectors, as its own comparisons make them, GCC 12 joins one lane after the other.
typedef __mmask16 WideFlags;

TOILE_INLINE WideFlags above(Wide a, Wide b) { return _mm512_cmp_ps_mask(a, b, _CMP_GT_OQ); }
TOILE_INLINE Wide either(WideFlags f, Wide a, Wide b) { return _mm512_mask_blend_ps(f, b, a); }
TOILE_INLINE bool any(WideFlags f) { return f != 0; }
TOILE_INLINE Wide root(Wide a) { return _mm512_sqrt_ps(a); }

TOILE_INLINE double* at(LanePoint* x, LaneOffset v) {
  return reinterpret_cast<double*>(reinterpret_cast<char*>(x) + v);
}
/// Two positions in one register.
TOILE_INLINE __m512d two(LanePoint* x, LaneOffset a, LaneOffset b) {
  return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(at(x, a))), _mm256_load_pd(at(x, b)), 1);
}

/// Ways from one vertex of each lane to another (m).
TOILE_INLINE Wide3 ways(LanePoint* x, const LaneOffset* from, const LaneOffset* to) {
  const auto pair = [&](int i) {
    return _mm512_cvtpd_ps(_mm512_sub_pd(two(x, to[i], to[i + 4]), two(x, from[i], from[i + 4])));
  };
  const auto four = [&](int i) {  // every fourth lane
    return _mm512_insertf32x8(_mm512_castps256_ps512(pair(i)), pair(i + 8), 1);
  };
  const __m512 a = four(0), b = four(1), c = four(2), d = four(3);
  const __m512d xy01 = _mm512_castps_pd(_mm512_unpacklo_ps(a, b)),
                xy23 = _mm512_castps_pd(_mm512_unpacklo_ps(c, d)),
                z01 = _mm512_castps_pd(_mm512_unpackhi_ps(a, b)),
                z23 = _mm512_castps_pd(_mm512_unpackhi_ps(c, d));
  return {_mm512_castpd_ps(_mm512_unpacklo_pd(xy01, xy23)), _mm512_castpd_ps(_mm512_unpackhi_pd(xy01, xy23)),
          _mm512_castpd_ps(_mm512_unpacklo_pd(z01, z23))};
}

/// Moves a vertex of each lane by `d`, two at a time: only nobody's point is that of two lanes, and it stays.
TOILE_INLINE void move(LanePoint* x, const LaneOffset* v, const Wide3& d) {
  const __m512d xy01 = _mm512_castps_pd(_mm512_unpacklo_ps(d.x, d.y)),
                xy23 = _mm512_castps_pd(_mm512_unpackhi_ps(d.x, d.y)),
                z01 = _mm512_castps_pd(_mm512_unpacklo_ps(d.z, kNothing)),
                z23 = _mm512_castps_pd(_mm512_unpackhi_ps(d.z, kNothing));
  const __m512d lanes[4] = {_mm512_unpacklo_pd(xy01, z01), _mm512_unpackhi_pd(xy01, z01),
                            _mm512_unpacklo_pd(xy23, z23), _mm512_unpackhi_pd(xy23, z23)};
  const auto pair = [&](int i, __m256 by) {
    const __m512d to = _mm512_add_pd(two(x, v[i], v[i + 4]), _mm512_cvtps_pd(by));
    _mm256_store_pd(at(x, v[i]), _mm512_castpd512_pd256(to));
    _mm256_store_pd(at(x, v[i + 4]), _mm512_extractf64x4_pd(to, 1));
  };
  for (int i = 0; i < 4; ++i) {
    pair(i, _mm512_castps512_ps256(_mm512_castpd_ps(lanes[i])));
    pair(i + 8, _mm512_extractf32x8_ps(_mm512_castpd_ps(lanes[i]), 1));
  }
}

}  // namespace
}  // namespace toile::solver::lanes
