#pragma once
// A trouser leg cut in one piece, which closes by its inner seam alone.

#include <vector>

#include "core/arrange/garment_graph.h"
#include "core/body/measure/landmarks.h"

namespace toile::arrange {

struct LegPiece {
  Index piece = kNone;
  measure::BodySide side = measure::kWearersLeft;
  Vec2 fork, up;       ///< m, between the inner seam's upper ends; unit vector, upwards from the hem
  double at_fork = 0;  ///< m, across between the seam's upper …
  double at_hem = 0;   ///< … and lower ends
  double length = 0;   ///< m, from the fork to the hem
};

/// The pieces of legs that are sewn to themselves and to another such piece. Which leg each is for, its
/// crotch tells: the front of it is the shorter one; where both are alike its name, else the order.
std::vector<LegPiece> leg_pieces(const GarmentGraph& graph);

}  // namespace toile::arrange
