#pragma once
// How pieces are made up, as it shows: what a tailor would choose for such cloth and such a shape.

#include <vector>

#include "server/render/scene.h"

namespace toile::render {

struct PanelMake {
  double thickness = 0;        ///< m, of the cloth
  double hem = 0;              ///< m, from a free edge to the stitches that hold it
  double stitched_beside = 0;  ///< m, from a seam to stitches that hold it down; 0: it has none
};

/// One for each panel, and for at least one. A hem is 18 mm deep and narrower on narrow pieces. Seams are
/// stitched down on thick cloth.
std::vector<PanelMake> panel_makes(const ClothView& cloth);

}  // namespace toile::render
