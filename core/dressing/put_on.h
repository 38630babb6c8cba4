#pragma once
// Tries the ways to put a garment on until one is certified.

#include <optional>

#include "core/base/run_context.h"
#include "core/dressing/dress.h"

namespace toile::dressing {

/// Tries each way on `coarse`, and carries the first that is certified there and not badly squeezed, else the
/// least squeezed, over to `fine`, where it must be certified again: `positions` are those of `fine`. Both
/// are of one pattern, placed and sewn alike; they may be the same. The ways before `first`, an index into
/// dressing_ways(), are passed over. Nothing where no way leads there, or where the context was cancelled.
/// Progress phase: "dress".
std::optional<Dressed> put_on(const sewing::Assembly& fine, const sewing::Assembly& coarse,
                              const Wearer& wearer, const RunContext& context, std::size_t first = 0);

/// The shape of `coarse` at the vertices of another mesh of the same pattern, by where they lie in the flat
/// pieces; sewn vertices together. m.
std::vector<Vec3> carried_over(const sewing::GarmentMesh& fine, const sewing::GarmentMesh& coarse,
                               std::span<const Vec3> shape);

}  // namespace toile::dressing
