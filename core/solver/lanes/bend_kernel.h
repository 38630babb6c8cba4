#pragma once
// Bending's pass (core/solver/constraints/bend.h says what it stands for). See eight.h.

#include "core/solver/lanes/eight.h"

namespace toile {
namespace {

/// Hinges that are bent less than this count as flat for unfolded(): sin²(θ/2), θ = 14°.
constexpr float kHardlyBent = 1.0F / 64;

/// Factor on jumps of length |j| = 2 sin(θ/2). The energy ½ k j² turns a hinge back by k sin θ: folded flat
/// it would rest, and sharp creases stood in the cloth as in cardboard. By 1 / (c (1 + c)/2), c = cos(θ/2),
/// it becomes 4 tan(θ/4), within 27 % of θ. `hard`: share·mobility over compliance; a hinge that is hard
/// anyway is put right in one step and must not overshoot.
TOILE_INLINE Eight unfolded(Eight squared, Eight hard) {
  const Eight c = root(larger(1 - (0.25F * squared - kHardlyBent), kOne * kHardlyBent));
  const Eight factor = 2 / (c * (1 + c));
  return factor * (1 + hard) / (1 + factor * hard);
}

TOILE_INLINE void solve(const BendPack& t, LanePoint* x) {
  const Eight3 e1 = ways(x, t.v[0], t.v[1]), e2 = ways(x, t.v[0], t.v[2]);
  Eight3 j[3], l[3];
  for (int k = 0; k < 3; ++k) {
    j[k] = e1 * load(t.own[k][0]) + e2 * load(t.own[k][1]) + ways(x, t.v[0], t.v[3 + k]) * load(t.far[k]);
    const Eight squared = dot(j[k], j[k]);
    const EightFlags bent = squared > 4 * kHardlyBent;
    if (any(bent)) j[k] = j[k] * (bent ? unfolded(squared, load(t.hard)) : kOne);
  }
  const Eight r0 = load(t.response[0]), r1 = load(t.response[1]), r2 = load(t.response[2]),
              r3 = load(t.response[3]), r4 = load(t.response[4]), r5 = load(t.response[5]);
  l[0] = j[0] * r0 + j[1] * r3 + j[2] * r4;
  l[1] = j[0] * r3 + j[1] * r1 + j[2] * r5;
  l[2] = j[0] * r4 + j[1] * r5 + j[2] * r2;
  Eight3 d1 = l[0] * load(t.own[0][0]), d2 = l[0] * load(t.own[0][1]), d0 = l[0] * load(t.far[0]);
  for (int k = 1; k < 3; ++k) {
    d1 = d1 + l[k] * load(t.own[k][0]);
    d2 = d2 + l[k] * load(t.own[k][1]);
    d0 = d0 + l[k] * load(t.far[k]);
  }
  for (int k = 0; k < 3; ++k) move(x, t.v[3 + k], l[k] * (-load(t.far[k]) * load(t.w[3 + k])));
  move(x, t.v[0], (d0 + d1 + d2) * load(t.w[0]));
  move(x, t.v[1], d1 * -load(t.w[1]));
  move(x, t.v[2], d2 * -load(t.w[2]));
}

void solve_bend_packs(const BendPack* packs, std::size_t count, LanePoint* x) {
  for (std::size_t i = 0; i < count; ++i) solve(packs[i], x);
}

}  // namespace
}  // namespace toile
