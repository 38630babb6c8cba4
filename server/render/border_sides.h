#pragma once
// The borders of cloth's pieces, for drawing: where they are sewn and where they end in a hem.

#include <vector>

#include "server/render/scene.h"

namespace toile::render {

/// A stretch of a piece's border from one corner to the next, all sewn or all not.
struct BorderSide {
  Index panel = 0;
  bool sewn = false;
  int slot = 0;  ///< 0 to kBorderSlots - 1; sides that meet at a corner differ
  std::vector<Index>
      vertices;               ///< of the cloth, in the direction of the triangles; the first again if closed
  std::vector<double> along;  ///< m of flat cloth from the first vertex, one per vertex
  std::vector<char> open;     ///< one per edge: its seam did not close
};

inline constexpr int kBorderSlots = 4;  ///< most pieces have four sides, which then stand in one each

/// Where a vertex lies on the flat cloth, m; where it is without flat cloth.
Vec3 flat_place(const ClothView& cloth, Index vertex);

/// All sides, piece by piece, in an order that follows from the triangles alone.
std::vector<BorderSide> border_sides(const ClothView& cloth);

/// The panel of a triangle; 0 where the cloth does not say.
Index panel_of(const ClothView& cloth, std::size_t triangle);

}  // namespace toile::render
