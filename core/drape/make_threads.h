#pragma once
// What leads the garment's vertices while it is sewn: threads, and the attachments that hold cloth where it
// is.

#include <span>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/sewing/assembly.h"
#include "core/solver/constraints/hold.h"
#include "core/solver/constraints/stitch.h"

namespace toile::drape {

/// A thread for each sewn pair that is not yet one vertex (`vertex_of[i]` is the solver's vertex of garment
/// vertex i), but for those of `lost` seams. Each pulls for the seam that it holds: where a side is sampled
/// finely, more and weaker threads pull. `particle_distance` (m) stands for pairs that hold no seam.
std::vector<solver::constraints::Stitch> make_stitches(const sewing::Assembly& assembly,
                                                       std::span<const Index> vertex_of,
                                                       const std::vector<bool>& lost,
                                                       double particle_distance);

/// Targets are where the attached vertices stood at the start; welded ones share the mean of theirs. What is
/// `released` is not held.
std::vector<solver::constraints::HeldVertex> make_holds(const DrapeInput& input,
                                                        const sewing::Assembly& assembly,
                                                        std::span<const Index> vertex_of, Index vertex_count,
                                                        const std::vector<bool>& released);

}  // namespace toile::drape
