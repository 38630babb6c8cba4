#pragma once
// Bending's pass (core/solver/constraints/bend.h says what it stands for). See wide.h.

#include "core/solver/lanes/wide.h"

namespace toile::solver::lanes {
namespace {

/// Hinges that are bent less than this count as flat for unfolded(): sin²(θ/2), θ = 14°.
constexpr float kHardlyBent = 1.0F / 64;

/// Factor on jumps of length |j| = 2 sin(θ/2). The energy ½ k j² turns a hinge back by k sin θ: folded flat
/// it would rest, and sharp creases stood in the cloth as in cardboard. By 1 / (c (1 + c)/2), c = cos(θ/2),
/// it becomes 4 tan(θ/4), within 27 % of θ. `hard`: share·mobility over compliance; a hinge that is hard
/// anyway is put right in one step and must not overshoot.
TOILE_INLINE Wide unfolded(Wide squared, Wide hard) {
  const Wide c = root(larger(1 - (0.25F * squared - kHardlyBent), kOne * kHardlyBent));
  return 2 * (1 + hard) / (c * (1 + c) + 2 * hard);
}

TOILE_INLINE void solve(const BendPack& t, LaneReader of, LanePoint* x) {
  const Wide3 e1 = ways(x, of(t.v[0]), of(t.v[1])), e2 = ways(x, of(t.v[0]), of(t.v[2]));
  Wide3 j[3], l[3];
  for (int k = 0; k < 3; ++k) {
    j[k] = e1 * of(t.own[k][0]) + e2 * of(t.own[k][1]) + ways(x, of(t.v[0]), of(t.v[3 + k])) * of(t.far[k]);
    const Wide squared = dot(j[k], j[k]);
    const WideFlags bent = above(squared, 4 * kHardlyBent);
    if (any(bent)) j[k] = j[k] * either(bent, unfolded(squared, of(t.hard)), kOne);
  }
  const Wide r0 = of(t.response[0]), r1 = of(t.response[1]), r2 = of(t.response[2]), r3 = of(t.response[3]),
             r4 = of(t.response[4]), r5 = of(t.response[5]);
  l[0] = j[0] * r0 + j[1] * r3 + j[2] * r4;
  l[1] = j[0] * r3 + j[1] * r1 + j[2] * r5;
  l[2] = j[0] * r4 + j[1] * r5 + j[2] * r2;
  Wide3 d1 = l[0] * of(t.own[0][0]), d2 = l[0] * of(t.own[0][1]), d0 = l[0] * of(t.far[0]);
  for (int k = 1; k < 3; ++k) {
    d1 = d1 + l[k] * of(t.own[k][0]);
    d2 = d2 + l[k] * of(t.own[k][1]);
    d0 = d0 + l[k] * of(t.far[k]);
  }
  for (int k = 0; k < 3; ++k) move(x, of(t.v[3 + k]), l[k] * (-of(t.far[k]) * of(t.w[3 + k])));
  move(x, of(t.v[0]), (d0 + d1 + d2) * of(t.w[0]));
  move(x, of(t.v[1]), d1 * -of(t.w[1]));
  move(x, of(t.v[2]), d2 * -of(t.w[2]));
}

void solve_bend_packs(const BendPack* packs, std::size_t count, LanePoint* x) {
  for (std::size_t i = 0; i < count; ++i) {
    for (int first = 0; first < kLanes; first += kWide) solve(packs[i], {first}, x);
  }
}

}  // namespace
}  // namespace toile::solver::lanes
