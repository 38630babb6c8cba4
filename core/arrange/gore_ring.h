#pragma once
// Skirts of many gores: no sheet before or behind the body holds them, they go around it one by one.

#include <vector>

#include "core/arrange/garment_graph.h"

namespace toile::arrange {

/// One gore of a ring, in its own plane.
struct Gore {
  Index piece = kNone;
  Vec2 top;                     ///< m, the middle of its upper end
  Vec2 up;                      ///< unit vector
  double width = 0, below = 0;  ///< m, at its upper and its lower end
  double length = 0;            ///< m, upwards
  double angle = 0;  ///< radians, of its middle, on from the first gore's; towards the wearer's left in front
};

/// Pieces that are sewn side to side into one ring of at least five, whose names tell neither front nor back,
/// in order around the body; empty where there is none. Those of `taken` (one a piece) do not count.
std::vector<Gore> gore_ring(const GarmentGraph& graph, const std::vector<bool>& taken);

}  // namespace toile::arrange
