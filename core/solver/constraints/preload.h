#pragma once
// What makes one pass a step as stiff at rest as the fabric is. A hard membrane takes its whole mobility
// (one_pass.h), so that at rest half of what it corrects is undone by its neighbours, which come before or
// after it: with λ from gravity, the strain is compliance·λ and half of mobility·λ more, many times too much
// at 2000 N/m, and each triangle's share of it depends on its place in the order. No local pass can carry
// that in a step, but at rest it does not change. So every triangle learns it: it is taken to be longer by a
// preload, and the preload follows what the strain at the end of a step is off from what the triangle's λ
// asks for. Its fixed point is the fabric's own law (integral action; an augmented Lagrangian's multiplier is
// such a memory, too).
//
// What comes late drives swings. Damping bears that as long as learning is slower than it; folds
// that are about to buckle bear hardly any, so cloth learns only where it is taut: where the tension around
// exceeds the buckling load of its triangles. True motion, which has no damping, learns nothing.

#include <functional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/solver/constraints/membrane.h"

namespace toile::solver::constraints {

/// When to learn and how much. The more has been learnt the less is added, until it ends and the cloth comes
/// to rest (steps that shrink, as in Robbins and Monro's stochastic approximation, 1951).
struct LearningPace {
  int steps = 0;      ///< since the last look at the strains
  double learnt = 0;  ///< sum of all shares

  /// Counts a step damped so (1/s); true when its strains are to be looked at.
  bool due(double damping);
  /// Share of what is off that is learnt now, after steps of `h` seconds.
  double next_share(double damping, double h);
  /// Enough has been learnt: preloads stay as they are.
  bool ended() const;
};

/// Moves preloads (of weft, warp and shear, one a triangle) by `share` of what the strains at x (m) are off
/// from what `noted` asks for: the λ of the step that led there (J s², positive where it pushes apart), of
/// substeps of `h` seconds. Slack triangles forget instead, `at_last` all that they know.
void learn_preloads(std::span<const MembraneTriangle> triangles, std::span<const Vec3> noted, double h,
                    double share, bool at_last, std::span<const Vec3> x, std::vector<Vec3>& preloads);

/// Whether cloth may give way whose triangle has its middle here (m).
using MayGive = std::function<bool(Vec3)>;

/// Cloth far beyond its limit at x (m) that all which was learnt has not brought back is forced around more
/// than it reaches. Where it may, its preload takes the strain beyond, bit by bit, as cloth does that gives
/// for good. True if some did.
bool give_way(std::span<const MembraneTriangle> triangles, std::span<const Vec3> x, const MayGive& may,
              std::vector<Vec3>& preloads);

/// Preloads with which a membrane has no stress at x (m), in whatever shape it is there.
std::vector<Vec3> preloads_at_rest(std::span<const MembraneTriangle> triangles, std::span<const Vec3> x);

}  // namespace toile::solver::constraints
