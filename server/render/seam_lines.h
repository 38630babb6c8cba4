#pragma once
// How far each cloth vertex lies from the borders of its piece: what seams and hems are drawn by.

#include <array>
#include <vector>

#include "server/render/border_sides.h"

namespace toile::render {

/// By slot of the sides: of all sides of the piece in a slot, the nearest one. Within a triangle these run
/// straight on, also where two sides meet, since those stand in different slots.
struct VertexLines {
  std::array<float, kBorderSlots> distance;  ///< m of flat cloth; 1 where no side is near
  std::array<float, kBorderSlots> along;     ///< m from the side's beginning to the nearest place on it
  std::array<float, kBorderSlots> kind;      ///< -1: a seam that did not close, 0: a seam, 2: a hem
};

inline constexpr float kFarFromLine = 1.0f;

/// Measures vertices of a piece.
class LineMeasure {
 public:
  explicit LineMeasure(const ClothView& cloth);
  VertexLines at(Index vertex, Index panel) const;

 private:
  struct Side {
    BorderSide border;
    std::vector<Vec3> places;  // flat, one per vertex of the side
    Aabb3 box;
  };
  void measure(const Side& side, Vec3 place, VertexLines& lines) const;

  const ClothView& cloth_;
  std::vector<std::vector<Side>> sides_;  // by panel
  double reach_ = 0;                      // m, farther sides do not count
};

}  // namespace toile::render
