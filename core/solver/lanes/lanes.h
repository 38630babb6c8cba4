#pragma once
// Constraints four at a time. A pack holds four triangles without a common vertex, so that they can be solved
// side by side; which four belong together is part of the data, so the bytes do not depend on how wide the
// processor is. The same kernels are compiled twice, for every x86-64 and for AVX2; kernels() chooses at run
// time. Only + − × ÷ √ and comparisons: both give the same bytes.

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/solver/constraints/bend.h"
#include "core/solver/constraints/membrane.h"

namespace toile {

inline constexpr int kLanes = 4;

/// Four coefficients side by side, as floats: packs are read whole in every step, and half the bytes are half
/// the way. Positions and sums are doubles.
struct alignas(16) Lanes {
  float at[kLanes] = {};
};

/// Constraints of one pack, kNone where it has fewer.
using LaneGroup = std::array<Index, kLanes>;

struct MembranePack {
  Index v[3][kLanes];
  int count = 0;  ///< lanes in use; the others repeat the first one's vertices and move nothing
  Lanes w[3], b[4], compliance[4], share;
};

/// Beside each membrane pack, where the cloth has strain limits.
struct LimitPack {
  Lanes limit[3], stop[3];  ///< of weft, warp, shear
};

struct BendPack {
  Index v[6][kLanes];  ///< a missing neighbour repeats corner 0, with weight 0
  int count = 0;
  Lanes w[6], own[3][2], far[3], response[6], hard;  ///< own: of corners 1 and 2; corner 0 takes what is left
};

/// Indices of constraints that share no vertex, up to four together, each constraint once; in order, but for
/// what had to wait. `vertices(i)` lists those of constraint i, kNone for none.
std::vector<LaneGroup> group_apart(Index count, Index vertex_count,
                                   const std::function<std::span<const Index>(Index)>& vertices);

/// Packs of prepared triangles, by groups of them.
std::vector<MembranePack> pack_membrane(std::span<const MembraneTriangle> triangles,
                                        std::span<const LaneGroup> groups, std::span<const double> w);
/// Empty where no triangle has a limit.
std::vector<LimitPack> pack_limits(std::span<const MembraneTriangle> triangles,
                                   std::span<const LaneGroup> groups);
std::vector<BendPack> pack_bending(std::span<const BendTriangle> triangles, std::span<const LaneGroup> groups,
                                   std::span<const double> w);

/// One Gauss-Seidel pass over packs; `limits` is null where there are none, `per_h2` 1 / h², `x` the
/// positions.
struct LaneKernels {
  void (*solve_membrane)(const MembranePack* packs, const LimitPack* limits, std::size_t count, double per_h2,
                         Vec3* x);
  void (*solve_bending)(const BendPack* packs, std::size_t count, Vec3* x);
};

/// For this processor.
const LaneKernels& lane_kernels();

/// One set for every processor, one for those with AVX2 (null when the compiler has none).
extern const LaneKernels plain_lane_kernels;
const LaneKernels* avx2_lane_kernels();

}  // namespace toile
