#pragma once
// Constraints side by side. A pack holds sixteen triangles without a common vertex, so that they can be
// solved all at once or in parts one after the other; which sixteen belong together is part of the data, so
// the bytes do not depend on how wide the processor is. The same kernels are compiled three times, for every
// x86-64, for AVX2 and for AVX-512; lane_kernels() chooses at run time. Only + − × ÷ √ and comparisons: all
// give the same bytes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/solver/constraints/bend.h"
#include "core/solver/constraints/membrane.h"
#include "core/solver/lanes/pack_plan.h"

namespace toile::solver::lanes {

/// Coefficients side by side.
struct alignas(64) Lanes {
  float at[kLanes] = {};
};

/// A position (m) that a register loads at once; the fourth place is 0.
struct alignas(32) LanePoint {
  double at[4] = {};
};

/// Where a vertex's LanePoint begins, in bytes from the first: what its address takes no arithmetic for.
using LaneOffset = std::uint32_t;
constexpr LaneOffset offset_of(Index v) { return static_cast<LaneOffset>(v) * sizeof(LanePoint); }

/// Lanes without a triangle move a point that is nobody's, one for each strip of a round behind the vertices,
/// with inverse masses of 0.
/// Inverse masses, compliances / h² and what limits take off come divided by the triangle's mobility: as they
/// are, their products leave the range of a float.
struct MembranePack {
  LaneOffset v[3][kLanes];
  Lanes w[3], b[4], soft[4], share;
  Lanes buckling;  ///< how far λ goes until cloth that is pushed together buckles
};

/// Beside each membrane pack, where the cloth has strain limits.
struct LimitPack {
  Lanes limit[3], stop[3];  ///< of weft, warp, shear
};

/// Beside each membrane pack: what core/solver/constraints/preload.h is about.
struct PreloadPack {
  Lanes strain[3];  ///< of weft, warp, shear: added to what is measured
  Lanes lambda[3];  ///< what the last pass that took note found
};

struct BendPack {
  LaneOffset v[6][kLanes];  ///< a missing neighbour repeats corner 0, with weight 0; lanes as in MembranePack
  Lanes w[6], own[3][2], far[3], response[6], hard;  ///< own: of corners 1 and 2; corner 0 takes what is left
};

/// Packs of triangles that were prepared for inverse masses `w` (1/kg) and substep `h` (s), by a plan of
/// them.
std::vector<MembranePack> pack_membrane(std::span<const constraints::MembraneTriangle> triangles,
                                        const PackPlan& plan, std::span<const double> w, double h);
/// What the λ of a triangle's lane is divided by.
double lane_unit(const constraints::MembraneTriangle& triangle, std::span<const double> w);
/// Empty where no triangle has a limit.
std::vector<LimitPack> pack_limits(std::span<const constraints::MembraneTriangle> triangles,
                                   const PackPlan& plan, std::span<const double> w);
std::vector<BendPack> pack_bending(std::span<const constraints::BendTriangle> triangles, const PackPlan& plan,
                                   std::span<const double> w);

/// One Gauss-Seidel pass over packs; `limits` is null where there are none, `x` the positions and nobody's
/// points behind them. A pass that takes note leaves its λ in `preloads`.
struct LaneKernels {
  void (*solve_membrane)(const MembranePack* packs, const LimitPack* limits, PreloadPack* preloads,
                         std::size_t count, bool takes_note, LanePoint* x);
  void (*solve_bending)(const BendPack* packs, std::size_t count, LanePoint* x);
};

/// The widest set that this processor can run, and all of them, the widest last.
const LaneKernels& lane_kernels();
std::vector<const LaneKernels*> runnable_lane_kernels();

/// One set for every processor, and those for some of them (null when the compiler has none).
extern const LaneKernels kPlainLaneKernels;
const LaneKernels* avx2_lane_kernels();
const LaneKernels* avx512_lane_kernels();

}  // namespace toile::solver::lanes
