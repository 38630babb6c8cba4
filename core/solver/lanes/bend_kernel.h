#pragma once
// Bending's pass (core/solver/constraints/bend.h says what it stands for). See four.h.

#include "core/solver/lanes/four.h"

namespace toile {
namespace {

/// Hinges that are bent less than this count as flat for unfolded(): sin²(θ/2), θ = 14°.
constexpr double kHardlyBent = 1.0 / 64;

/// Factor on jumps of length |j| = 2 sin(θ/2). The energy ½ k j² turns a hinge back by k sin θ: folded flat
/// it would rest, and sharp creases stood in the cloth as in cardboard. By 1 / (c (1 + c)/2), c = cos(θ/2),
/// it becomes 4 tan(θ/4), within 27 % of θ. `hard`: share·mobility over compliance; a hinge that is hard
/// anyway is put right in one step and must not overshoot.
TOILE_INLINE Four unfolded(Four squared, Four hard) {
  const Four c = root(larger(1 - (0.25 * squared - kHardlyBent), kOne * kHardlyBent));
  const Four factor = 2 / (c * (1 + c));
  return factor * (1 + hard) / (1 + factor * hard);
}

TOILE_INLINE void solve(const BendPack& t, Vec3* x) {
  const Four3 x0 = gather(x, t.v[0]), x1 = gather(x, t.v[1]), x2 = gather(x, t.v[2]);
  const Four3 e1 = x1 - x0, e2 = x2 - x0;
  Four3 f[3], j[3], l[3];
  for (int k = 0; k < 3; ++k) {
    f[k] = gather(x, t.v[3 + k]);
    j[k] = e1 * load(t.own[k][0]) + e2 * load(t.own[k][1]) + (f[k] - x0) * load(t.far[k]);
    const Four squared = dot(j[k], j[k]);
    const FourFlags bent = squared > 4 * kHardlyBent;
    if (any(bent)) j[k] = j[k] * (bent ? unfolded(squared, load(t.hard)) : kOne);
  }
  const Four r0 = load(t.response[0]), r1 = load(t.response[1]), r2 = load(t.response[2]),
             r3 = load(t.response[3]), r4 = load(t.response[4]), r5 = load(t.response[5]);
  l[0] = j[0] * r0 + j[1] * r3 + j[2] * r4;
  l[1] = j[0] * r3 + j[1] * r1 + j[2] * r5;
  l[2] = j[0] * r4 + j[1] * r5 + j[2] * r2;
  Four3 d1 = l[0] * load(t.own[0][0]), d2 = l[0] * load(t.own[0][1]), d0 = l[0] * load(t.far[0]);
  for (int k = 1; k < 3; ++k) {
    d1 = d1 + l[k] * load(t.own[k][0]);
    d2 = d2 + l[k] * load(t.own[k][1]);
    d0 = d0 + l[k] * load(t.far[k]);
  }
  // Far vertices first: where one is missing, corner 0 stands in for it and is written last.
  for (int k = 0; k < 3; ++k)
    scatter(x, t.v[3 + k], t.count, f[k] - l[k] * (load(t.far[k]) * load(t.w[3 + k])));
  scatter(x, t.v[0], t.count, x0 + (d0 + d1 + d2) * load(t.w[0]));
  scatter(x, t.v[1], t.count, x1 - d1 * load(t.w[1]));
  scatter(x, t.v[2], t.count, x2 - d2 * load(t.w[2]));
}

void solve_bend_packs(const BendPack* packs, std::size_t count, Vec3* x) {
  for (std::size_t i = 0; i < count; ++i) solve(packs[i], x);
}

}  // namespace
}  // namespace toile
