#pragma once
// The membrane's pass (core/solver/constraints/membrane.h says what it stands for). See wide.h.

#include <type_traits>

#include "core/solver/lanes/wide.h"

namespace toile::solver::lanes {
namespace {

constexpr auto kBuckled = static_cast<float>(constraints::kBuckledStiffness);

/// What the triangles' strains ask for, lane by lane: symmetric systems A λ = r, solved, that can still
/// change along one direction after another. Entries (00, 11, 22, 01, 02, 12); λ > 0 pushes apart.
struct WideResponses {
  Wide inverse[6];
  Wide3 lambda;

  TOILE_INLINE Wide3 times(const Wide3& d) const {
    return {inverse[0] * d.x + inverse[3] * d.y + inverse[4] * d.z,
            inverse[3] * d.x + inverse[1] * d.y + inverse[5] * d.z,
            inverse[4] * d.x + inverse[5] * d.y + inverse[2] * d.z};
  }

  /// Cramer's rule; `m` is positive definite.
  TOILE_INLINE void solve(const Wide (&m)[6], const Wide3& r) {
    const Wide c00 = m[1] * m[2] - m[5] * m[5], c01 = m[4] * m[5] - m[3] * m[2],
               c02 = m[3] * m[5] - m[4] * m[1];
    const Wide per = kOne / (m[0] * c00 + m[3] * c01 + m[4] * c02);
    inverse[0] = c00 * per;
    inverse[3] = c01 * per;
    inverse[4] = c02 * per;
    inverse[1] = (m[0] * m[2] - m[4] * m[4]) * per;
    inverse[2] = (m[0] * m[1] - m[3] * m[3]) * per;
    inverse[5] = (m[3] * m[4] - m[0] * m[5]) * per;
    lambda = times(r);
  }

  /// Where `here`: A d dᵀ of `more` comes into A where d·λ is past `from`, so that λ does not jump there
  /// (Sherman and Morrison). q = A⁻¹ d. Elsewhere k = 0 changes nothing, so it is left out where it is 0 in
  /// all.
  TOILE_INLINE void change(WideFlags here, const Wide3& q, Wide dq, Wide over, Wide more) {
    if (!any(here)) return;
    const Wide k = either(here, more / (kOne + more * dq), kNothing);
    lambda = lambda - q * (k * over);
    const Wide3 p = q * k;
    inverse[0] -= p.x * q.x;
    inverse[1] -= p.y * q.y;
    inverse[2] -= p.z * q.z;
    inverse[3] -= p.x * q.y;
    inverse[4] -= p.x * q.z;
    inverse[5] -= p.y * q.z;
  }
  TOILE_INLINE void change(WideFlags here, const Wide3& d, Wide more, Wide from) {
    const Wide3 q = times(d);
    change(here, q, dot(d, q), dot(d, lambda) - from, more);
  }
  /// The same along warp or weft.
  TOILE_INLINE void soften_weft(Wide more, Wide from) {
    change(above(lambda.x, from), {inverse[0], inverse[3], inverse[4]}, inverse[0], lambda.x - from, more);
  }
  TOILE_INLINE void soften_warp(Wide more, Wide from) {
    change(above(lambda.y, from), {inverse[3], inverse[1], inverse[5]}, inverse[1], lambda.y - from, more);
  }
};

/// Cloth that is pushed together gives way along warp, weft, and the bias that shear pushes together: the
/// stress along n = (1, ±1)/√2 is (σ_weft + σ_warp)/2 ± σ_shear, and folds across n shorten the cloth by the
/// same combination. `c`: compliances of weft, warp, coupling, shear.
TOILE_INLINE void buckle(const Wide (&c)[4], Wide from, WideResponses& r) {
  constexpr float kSlack = 1 / kBuckled - 1;
  r.soften_weft(c[0] * kSlack, from);
  r.soften_warp(c[1] * kSlack, from);
  const Wide3 bias{kOne * 0.5F, kOne * 0.5F, either(above(kNothing, r.lambda.z), -kOne, kOne)};
  const Wide along = (c[0] + c[1] + 2 * c[2] + c[3]) * 0.25F;  // compliance of a strip cut on the bias
  r.change(above(dot(bias, r.lambda), from), bias, along * kSlack, from);
}

/// Which strain a stress asks for beyond a limit L: ε = C σ − β q (q·σ − L) with q a column of C. That is a
/// second spring beside the first, from L on.
TOILE_INLINE void keep_limits(const LimitPack& l, LaneReader of, const Wide (&c)[4], WideFlags here,
                              WideResponses& r) {
  const Wide stop_weft = of(l.stop[0]), stop_warp = of(l.stop[1]), stop_shear = of(l.stop[2]);
  const Wide most_weft = -of(l.limit[0]), most_warp = -of(l.limit[1]), most_shear = of(l.limit[2]);
  const Wide3 weft{c[0], c[2], kNothing}, warp{c[2], c[1], kNothing}, shear{kNothing, kNothing, c[3]};
  r.change(here & above(stop_weft, 0) & above(most_weft, dot(weft, r.lambda)), weft, -stop_weft, most_weft);
  r.change(here & above(stop_warp, 0) & above(most_warp, dot(warp, r.lambda)), warp, -stop_warp, most_warp);
  const Wide sheared = dot(shear, r.lambda);
  r.change(here & above(stop_shear, 0) & above(magnitude(sheared), most_shear), shear, -stop_shear,
           either(above(kNothing, sheared), -most_shear, most_shear));
}

template <bool kTakesNote>
TOILE_INLINE void solve(const MembranePack& t, const LimitPack* limits, PreloadPack& preload, LaneReader of,
                        LanePoint* x) {
  const Wide w0 = of(t.w[0]), w1 = of(t.w[1]), w2 = of(t.w[2]), share = of(t.share);
  const Wide b0 = of(t.b[0]), b1 = of(t.b[1]), b2 = of(t.b[2]), b3 = of(t.b[3]);
  const Wide3 e1 = ways(x, of(t.v[0]), of(t.v[1])), e2 = ways(x, of(t.v[0]), of(t.v[2]));
  const Wide3 fu = e1 * b0 + e2 * b1, fv = e1 * b2 + e2 * b3;
  const Wide lu = root(dot(fu, fu)), lv = root(dot(fv, fv));
  // Else collapsed to a line: no direction to push in.
  const WideFlags sound = above(lu, 1e-6F) & above(lv, 1e-6F);
  const Wide3 nu = fu * (kOne / lu), nv = fv * (kOne / lv);

  // Gradients: with respect to corner 1, corner 2, and minus their sum for corner 0.
  const Wide s0 = b0 + b1, s1 = b2 + b3;
  const Wide3 shear1 = fv * b0 + fu * b2, shear2 = fv * b1 + fu * b3, shear0 = shear1 + shear2;
  const Wide uv = dot(nu, nv);
  const Wide mass_uu = w0 * s0 * s0 + w1 * b0 * b0 + w2 * b1 * b1;
  const Wide mass_vv = w0 * s1 * s1 + w1 * b2 * b2 + w2 * b3 * b3;
  const Wide mass_uv = (w0 * s0 * s1 + w1 * b0 * b2 + w2 * b1 * b3) * uv;
  const Wide3 along_u = shear0 * (w0 * s0) + shear1 * (w1 * b0) + shear2 * (w2 * b1);
  const Wide3 along_v = shear0 * (w0 * s1) + shear1 * (w1 * b2) + shear2 * (w2 * b3);
  const Wide mass_ss = w0 * dot(shear0, shear0) + w1 * dot(shear1, shear1) + w2 * dot(shear2, shear2);
  const Wide soft[4] = {of(t.soft[0]), of(t.soft[1]), of(t.soft[2]), of(t.soft[3])};
  const Wide system[6] = {share * mass_uu + soft[0], share * mass_vv + soft[1], share * mass_ss + soft[3],
                          share * mass_uv + soft[2], share * dot(along_u, nu),  share * dot(along_v, nv)};
  WideResponses response;
  response.solve(system, {kOne - lu - of(preload.strain[0]), kOne - lv - of(preload.strain[1]),
                          -dot(fu, fv) - of(preload.strain[2])});
  buckle(soft, of(t.buckling), response);
  // Torn out to twice its size a triangle is as mobile as no limit reckoned with; its plain spring brings it
  // back.
  if (limits != nullptr) keep_limits(*limits, of, soft, above(kOne * 4, lu + lv), response);

  const Wide3 lambda = response.lambda;
  const Wide3 pu = nu * lambda.x, pv = nv * lambda.y;
  const Wide3 d1 = pu * b0 + pv * b2 + shear1 * lambda.z, d2 = pu * b1 + pv * b3 + shear2 * lambda.z,
              d0 = d1 + d2;
  // However far the cloth is out of shape, no corner moves by more than its triangle's least height: beyond
  // that the linear guess points nowhere, and narrow triangles flew apart.
  const Wide steep = larger(larger(b0 * b0 + b2 * b2, b1 * b1 + b3 * b3), s0 * s0 + s1 * s1);
  const Wide way =
      steep * larger(larger(dot(d1, d1) * w1 * w1, dot(d2, d2) * w2 * w2), dot(d0, d0) * w0 * w0);
  const WideFlags far = above(way, 1);
  const Wide scale = any(far) ? either(far, kOne / root(way), kOne) : kOne;
  const auto kept = [&](const Wide3& d, Wide s) {
    return Wide3{either(sound, d.x * s, kNothing), either(sound, d.y * s, kNothing),
                 either(sound, d.z * s, kNothing)};
  };
  if (kTakesNote) {
    const Wide3 applied = kept(lambda, scale);
    of(preload.lambda[0]) = applied.x;
    of(preload.lambda[1]) = applied.y;
    of(preload.lambda[2]) = applied.z;
  }
  move(x, of(t.v[0]), kept(d0, -w0 * scale));
  move(x, of(t.v[1]), kept(d1, w1 * scale));
  move(x, of(t.v[2]), kept(d2, w2 * scale));
}

void solve_membrane_packs(const MembranePack* packs, const LimitPack* limits, PreloadPack* preloads,
                          std::size_t count, bool takes_note, LanePoint* x) {
  const auto solve_all = [&](auto note, auto limits_of) {
    for (std::size_t i = 0; i < count; ++i) {
      for (int first = 0; first < kLanes; first += kWide) {
        solve<decltype(note)::value>(packs[i], limits_of(i), preloads[i], {first}, x);
      }
    }
  };
  const auto solve_noting = [&](auto note) {
    if (limits == nullptr) {
      solve_all(note, [](std::size_t) { return nullptr; });
    } else {
      solve_all(note, [&](std::size_t i) { return limits + i; });
    }
  };
  if (takes_note) {
    solve_noting(std::true_type());
  } else {
    solve_noting(std::false_type());
  }
}

}  // namespace
}  // namespace toile::solver::lanes
