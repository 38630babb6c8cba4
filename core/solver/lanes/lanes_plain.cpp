#include "core/solver/lanes/bend_kernel.h"
#include "core/solver/lanes/membrane_kernel.h"

namespace toile::solver::lanes {

const LaneKernels kPlainLaneKernels{solve_membrane_packs, solve_bend_packs};

}  // namespace toile::solver::lanes
