#pragma once
// The hinges of creases, along lines of a piece and along its seams.

#include <span>
#include <vector>

#include "core/sewing/assembly.h"
#include "core/solver/constraints/fold.h"

namespace toile::drape {

/// The hinges in the solver's vertices, of which `vertex_of` names that of each garment vertex; those along a
/// seam as far as that is joined, and where just two pieces meet. What is pressed back (Assembly) counts as
/// turned over from the start.
std::vector<solver::constraints::FoldHinge> fold_hinges(const std::vector<sewing::Crease>& creases,
                                                        const sewing::Assembly& assembly,
                                                        std::span<const Index> vertex_of);

}  // namespace toile::drape
