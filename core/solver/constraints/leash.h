#pragma once
// Leashes: springs from patches of the cloth to places in space, as fingers hold them. A leash is compliant
// (XPBD: Macklin, Müller, Chentanez 2016), and its force has a limit, as fingers that slip have. It moves
// positions before contacts and bounds, which cut what would go through: a hand behind a body waits.

#include <span>
#include <vector>

#include "core/base/types.h"

namespace toile::solver::constraints {

struct Leash {
  std::vector<Index> patch;   ///< vertices of the solver, each once
  std::vector<double> share;  ///< of each, summing to 1: what is held is their mean
  Vec3 target;                ///< m
  double stiffness = 0;       ///< N/m
  double most_force = 0;      ///< N
};

/// m, what a leash holds.
Vec3 held_by(const Leash& leash, std::span<const Vec3> x);

/// One pass: each patch goes towards its target as far as a spring, implicit in time, moves it in a step of
/// `h` (s). `w`: inverse masses (1/kg).
void solve_leashes(std::span<const Leash> leashes, std::span<const double> w, double h, std::span<Vec3> x);

}  // namespace toile::solver::constraints
