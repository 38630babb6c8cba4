#pragma once

#include <span>

#include "core/drape/drape_input.h"
#include "core/sewing/assembly.h"
#include "core/solver/cloth_features.h"

namespace toile {

/// The garment's notions, and the air, for the solver. `vertex_of[i]` is the solver's vertex of garment
/// vertex i. Derived afresh whenever a weld changes the solver's vertices.
ClothFeatures make_features(const DrapeInput& input, const Assembly& assembly,
                            std::span<const Index> vertex_of, Index vertex_count);

}  // namespace toile
