// Compiled for AVX-512 (see CMakeLists.txt); called only where the processor has it.

#include "core/solver/lanes/bend_kernel.h"
#include "core/solver/lanes/membrane_kernel.h"

namespace toile::solver::lanes {

const LaneKernels* avx512_lane_kernels() {
#ifdef __AVX512F__
  static constexpr LaneKernels kernels{solve_membrane_packs, solve_bend_packs};
  return &kernels;
#else
  return nullptr;
#endif
}

}  // namespace toile::solver::lanes
