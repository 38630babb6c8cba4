#pragma once
// What holds trousers and skirts up that have no waistband and are as wide at the waist as at the hip.

#include <vector>

#include "core/pattern/pattern.h"
#include "core/project/project.h"

namespace toile::create {

/// Elastics along the upper edges of legs and skirts where no piece is a bodice or a waistband, no seam (of
/// the pattern or sewn later, `proposed`) takes these edges, and each piece is nearly as wide there as at the
/// hip: such garments are pulled on and have a casing, grown on, or sewn on as a band of their own length,
/// along whose free edge the elastic goes then. One a piece, as a document has them; none where the waist is
/// shaped.
std::vector<project::ProjectElastic> waist_elastics(const pattern::Pattern& pattern,
                                                    const std::vector<pattern::Seam>& proposed);

}  // namespace toile::create
