#pragma once
// One Gauss-Seidel pass a substep leaves a constraint softer than asked. At rest, gravity moves everything by
// the same amount, and what a constraint with mobility g = G W Gᵀ corrects is undone by its neighbours: about
// half of it before its turn and half after. So its compliance comes out as compliance/h² + share·g
// − g/2, and is as asked when the share of the mobility in its system is one half. That is safe only while
// the constraint is soft; a hard one takes its whole mobility, as plain XPBD does, and stays a little soft.

#include <algorithm>

namespace toile::solver {

/// Share of its mobility that a constraint puts into its system: 1/2 where it is twice as soft as mobile or
/// softer, towards 1 where it is hard. `soft` is its compliance / h², `free` its mobility (traces, same
/// unit).
constexpr double one_pass_share(double soft, double free) {
  return free > 0 ? std::max(0.5, 1 - 0.25 * soft / free) : 1;
}

}  // namespace toile::solver
