#pragma once
// Cloth that nobody wears. Sizes are the project's own.

#include "core/draft/garment.h"

namespace toile::draft {

/// Six trapezoids of one shape, each of another fabric, hung by their two upper corners: what Figure 8 of Min
/// and others shows of one.
Garment draft_trapezoids();

/// A round cloth on a round table, 30 cm longer than its top all around.
Garment draft_tablecloth();

/// Two squares, sewn all around and filled, on a bench.
Garment draft_cushion();

}  // namespace toile::draft
