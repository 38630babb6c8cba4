#pragma once
// Sleeves: before and behind the arm, or around it.

#include <optional>
#include <vector>

#include "core/arrange/flat_layout.h"
#include "core/arrange/garment_graph.h"
#include "core/body/measure/landmarks.h"
#include "core/sewing/placement.h"

namespace toile::arrange {

/// A tube's own line in its flat piece: from the end that is sewn to the garment (the cap) to the free one.
struct SleeveLine {
  Vec2 along;          ///< unit vector, away from the cap
  Vec2 begin;          ///< m, on the middle line, level with the first stitch of the long seams
  double length = 0;   ///< m, of the long seams
  double breadth = 0;  ///< m, across
  double taper = 0;    ///< by how much narrower it gets along the seams, m a metre; 0 where nothing tells
};

/// By the seams that run along the sleeve, to itself or to its other half; without those by the cap alone.
SleeveLine line_of_sleeve(const GarmentGraph& graph, Index piece, const std::vector<Index>& limb);

/// The pose at which the sleeve's middle lies on the arm's, its long seams beginning `out` (m) beyond where
/// the arm leaves the trunk.
FlatMove sleeve_pose(const SleeveLine& line, const measure::ArmLine& arm, double out, bool mirrored);

/// The sleeve rolled around the arm, its seam under the arm, `out` as above: as a cone where it tapers, so
/// that it covers as much of the circle at the hand as at the shoulder. A narrow end on a wide cylinder is a
/// flat strip beside the wrist, and closes there.
sewing::WrappedPlacement around_arm(const SleeveLine& line, const measure::ArmLine& arm,
                                    measure::BodySide side, double radius, double out, bool flipped);

}  // namespace toile::arrange
