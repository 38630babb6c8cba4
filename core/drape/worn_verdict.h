#pragma once
// Whether the body wears what was draped.

#include <optional>
#include <span>
#include <vector>

#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/dressing/person.h"
#include "core/preflight/finding.h"
#include "core/sewing/garment_mesh.h"

namespace toile::drape {

struct WornVerdict {
  Worn worn = Worn::kNobody;
  preflight::Findings findings;  ///< why not
};

/// The height of the highest vertex of each panel, m.
std::vector<double> tops_of(const sewing::GarmentMesh& garment, std::span<const Vec3> x);

/// Rings around limbs, pieces where they belong (worn_place.h), nothing that has slipped far down from where
/// it began, not all on the ground, no seam among `open`, and no piece missing but linings, facings and
/// pockets. Where nothing is sewn it is only judged whether it fell: several pieces that no seam joins are
/// not worn once one of them came down, one sheet not once it lies on the ground. `x`: m, one a garment
/// vertex; `tops`: tops_of() where the garment began.
WornVerdict judge_worn(const DrapeInput& input, const std::optional<dressing::Person>& person,
                       const sewing::GarmentMesh& garment, std::span<const Vec3> x,
                       std::span<const double> tops, const std::vector<OpenSeam>& open);

}  // namespace toile::drape
