#pragma once

#include <optional>
#include <span>

#include "core/drape/drape_input.h"
#include "core/dressing/person.h"
#include "core/sewing/assembly.h"
#include "core/solver/cloth_features.h"

namespace toile::drape {

/// The garment's notions, its attachments that lead somewhere and are not yet released, and the air, for the
/// solver. `vertex_of[i]` is the solver's vertex of garment vertex i. Derived afresh whenever a weld changes
/// the solver's vertices, and when an attachment is released. What lies over the shoulders
/// of `wearer` is kept there (shoulder_holds.h).
solver::ClothFeatures make_features(const DrapeInput& input, const sewing::Assembly& assembly,
                                    std::span<const Index> vertex_of, Index vertex_count,
                                    const std::vector<bool>& released,
                                    const std::optional<dressing::Person>& wearer = {});

/// m; how far what attachment `a` leads or holds is from where it should be, at most; `x` as the garment's
/// vertices. Of one that keeps a height: in height.
double off_hold(const DrapeInput& input, const sewing::Assembly& assembly, std::size_t a,
                std::span<const Vec3> x);

}  // namespace toile::drape
