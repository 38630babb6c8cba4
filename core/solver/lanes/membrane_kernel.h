#pragma once
// The membrane's pass (core/solver/constraints/membrane.h says what it stands for). See eight.h.

#include "core/solver/lanes/eight.h"

namespace toile {
namespace {

/// Share of its stiffness that cloth has left once it has buckled between the vertices (membrane.h).
constexpr float kBuckled = 0.05F;

/// What eight triangles' strains ask for: symmetric systems A λ = r, solved, that can still change along one
/// direction after another. Entries (00, 11, 22, 01, 02, 12); λ > 0 pushes apart.
struct EightResponses {
  Eight inverse[6];
  Eight3 lambda;

  TOILE_INLINE Eight3 times(const Eight3& d) const {
    return {inverse[0] * d.x + inverse[3] * d.y + inverse[4] * d.z,
            inverse[3] * d.x + inverse[1] * d.y + inverse[5] * d.z,
            inverse[4] * d.x + inverse[5] * d.y + inverse[2] * d.z};
  }

  /// Cramer's rule; `m` is positive definite.
  TOILE_INLINE void solve(const Eight (&m)[6], const Eight3& r) {
    const Eight c00 = m[1] * m[2] - m[5] * m[5], c01 = m[4] * m[5] - m[3] * m[2],
                c02 = m[3] * m[5] - m[4] * m[1];
    const Eight per = kOne / (m[0] * c00 + m[3] * c01 + m[4] * c02);
    inverse[0] = c00 * per, inverse[3] = c01 * per, inverse[4] = c02 * per;
    inverse[1] = (m[0] * m[2] - m[4] * m[4]) * per;
    inverse[2] = (m[0] * m[1] - m[3] * m[3]) * per;
    inverse[5] = (m[3] * m[4] - m[0] * m[5]) * per;
    lambda = times(r);
  }

  /// Where `here`: A d dᵀ of `more` comes into A where d·λ is past `from`, so that λ does not jump there
  /// (Sherman and Morrison). q = A⁻¹ d.
  TOILE_INLINE void change(EightFlags here, const Eight3& q, Eight dq, Eight over, Eight more) {
    if (!any(here)) return;
    const Eight k = here ? more / (kOne + more * dq) : kNothing;
    lambda = lambda - q * (k * over);
    const Eight3 p = q * k;
    inverse[0] -= p.x * q.x, inverse[1] -= p.y * q.y, inverse[2] -= p.z * q.z;
    inverse[3] -= p.x * q.y, inverse[4] -= p.x * q.z, inverse[5] -= p.y * q.z;
  }
  TOILE_INLINE void change(EightFlags here, const Eight3& d, Eight more, Eight from) {
    const Eight3 q = times(d);
    change(here, q, dot(d, q), dot(d, lambda) - from, more);
  }
  /// The same along warp or weft.
  TOILE_INLINE void soften_weft(Eight more, Eight from) {
    change(lambda.x > from, {inverse[0], inverse[3], inverse[4]}, inverse[0], lambda.x - from, more);
  }
  TOILE_INLINE void soften_warp(Eight more, Eight from) {
    change(lambda.y > from, {inverse[3], inverse[1], inverse[5]}, inverse[1], lambda.y - from, more);
  }
};

/// Cloth that is pushed together gives way along warp, weft, and the bias that shear pushes together: the
/// stress along n = (1, ±1)/√2 is (σ_weft + σ_warp)/2 ± σ_shear, and folds across n shorten the cloth by the
/// same combination. `c`: compliances of weft, warp, coupling, shear.
TOILE_INLINE void buckle(const Eight (&c)[4], Eight from, EightResponses& r) {
  constexpr float kSlack = 1 / kBuckled - 1;
  r.soften_weft(c[0] * kSlack, from);
  r.soften_warp(c[1] * kSlack, from);
  const Eight3 bias{kOne * 0.5F, kOne * 0.5F, r.lambda.z < 0 ? -kOne : kOne};
  const Eight along = (c[0] + c[1] + 2 * c[2] + c[3]) * 0.25F;  // compliance of a strip cut on the bias
  r.change(dot(bias, r.lambda) > from, bias, along * kSlack, from);
}

/// Which strain a stress asks for beyond a limit L: ε = C σ − β q (q·σ − L) with q a column of C. That is a
/// second spring beside the first, from L on.
TOILE_INLINE void keep_limits(const LimitPack& l, const Eight (&c)[4], EightFlags here, EightResponses& r) {
  const Eight stop_weft = load(l.stop[0]), stop_warp = load(l.stop[1]), stop_shear = load(l.stop[2]);
  const Eight most_weft = -load(l.limit[0]), most_warp = -load(l.limit[1]), most_shear = load(l.limit[2]);
  const Eight3 weft{c[0], c[2], kNothing}, warp{c[2], c[1], kNothing}, shear{kNothing, kNothing, c[3]};
  r.change(here & (stop_weft > 0) & (dot(weft, r.lambda) < most_weft), weft, -stop_weft, most_weft);
  r.change(here & (stop_warp > 0) & (dot(warp, r.lambda) < most_warp), warp, -stop_warp, most_warp);
  const Eight sheared = dot(shear, r.lambda), size = sheared < 0 ? -sheared : sheared;
  r.change(here & (stop_shear > 0) & (size > most_shear), shear, -stop_shear,
           sheared < 0 ? -most_shear : most_shear);
}

TOILE_INLINE void solve(const MembranePack& t, const LimitPack* limits, LanePoint* x) {
  const Eight w0 = load(t.w[0]), w1 = load(t.w[1]), w2 = load(t.w[2]), share = load(t.share);
  const Eight b0 = load(t.b[0]), b1 = load(t.b[1]), b2 = load(t.b[2]), b3 = load(t.b[3]);
  const Eight3 e1 = ways(x, t.v[0], t.v[1]), e2 = ways(x, t.v[0], t.v[2]);
  const Eight3 fu = e1 * b0 + e2 * b1, fv = e1 * b2 + e2 * b3;
  const Eight lu = root(dot(fu, fu)), lv = root(dot(fv, fv));
  const EightFlags sound = (lu > 1e-6F) & (lv > 1e-6F);  // else collapsed to a line: no direction to push in
  const Eight3 nu = fu * (kOne / lu), nv = fv * (kOne / lv);

  // Gradients: with respect to corner 1, corner 2, and minus their sum for corner 0.
  const Eight s0 = b0 + b1, s1 = b2 + b3;
  const Eight3 shear1 = fv * b0 + fu * b2, shear2 = fv * b1 + fu * b3, shear0 = shear1 + shear2;
  const Eight uv = dot(nu, nv);
  const Eight mass_uu = w0 * s0 * s0 + w1 * b0 * b0 + w2 * b1 * b1;
  const Eight mass_vv = w0 * s1 * s1 + w1 * b2 * b2 + w2 * b3 * b3;
  const Eight mass_uv = (w0 * s0 * s1 + w1 * b0 * b2 + w2 * b1 * b3) * uv;
  const Eight3 along_u = shear0 * (w0 * s0) + shear1 * (w1 * b0) + shear2 * (w2 * b1);
  const Eight3 along_v = shear0 * (w0 * s1) + shear1 * (w1 * b2) + shear2 * (w2 * b3);
  const Eight mass_ss = w0 * dot(shear0, shear0) + w1 * dot(shear1, shear1) + w2 * dot(shear2, shear2);
  const Eight soft[4] = {load(t.soft[0]), load(t.soft[1]), load(t.soft[2]), load(t.soft[3])};
  const Eight system[6] = {share * mass_uu + soft[0], share * mass_vv + soft[1], share * mass_ss + soft[3],
                           share * mass_uv + soft[2], share * dot(along_u, nu),  share * dot(along_v, nv)};
  EightResponses response;
  response.solve(system, {kOne - lu, kOne - lv, -dot(fu, fv)});
  buckle(soft, load(t.buckling), response);
  // Torn out to twice its size a triangle is as mobile as no limit reckoned with; its plain spring brings it
  // back.
  if (limits != nullptr) keep_limits(*limits, soft, lu + lv < 4, response);

  const Eight3 lambda = response.lambda;
  const Eight3 pu = nu * lambda.x, pv = nv * lambda.y;
  const Eight3 d1 = pu * b0 + pv * b2 + shear1 * lambda.z, d2 = pu * b1 + pv * b3 + shear2 * lambda.z,
               d0 = d1 + d2;
  // However far the cloth is out of shape, no corner moves by more than its triangle's least height: beyond
  // that the linear guess points nowhere, and narrow triangles flew apart.
  const Eight steep = larger(larger(b0 * b0 + b2 * b2, b1 * b1 + b3 * b3), s0 * s0 + s1 * s1);
  const Eight way =
      steep * larger(larger(dot(d1, d1) * w1 * w1, dot(d2, d2) * w2 * w2), dot(d0, d0) * w0 * w0);
  const EightFlags far = way > 1;
  const Eight scale = any(far) ? (far ? kOne / root(way) : kOne) : kOne;
  const auto kept = [&](const Eight3& d, Eight s) {
    return Eight3{sound ? d.x * s : kNothing, sound ? d.y * s : kNothing, sound ? d.z * s : kNothing};
  };
  move(x, t.v[0], kept(d0, -w0 * scale));
  move(x, t.v[1], kept(d1, w1 * scale));
  move(x, t.v[2], kept(d2, w2 * scale));
}

void solve_membrane_packs(const MembranePack* packs, const LimitPack* limits, std::size_t count,
                          LanePoint* x) {
  if (limits == nullptr) {
    for (std::size_t i = 0; i < count; ++i) solve(packs[i], nullptr, x);
  } else {
    for (std::size_t i = 0; i < count; ++i) solve(packs[i], limits + i, x);
  }
}

}  // namespace
}  // namespace toile
