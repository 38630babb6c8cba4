#pragma once

#include <string>
#include <vector>

#include "server/render/letters.h"

namespace toile::render {

/// What the colours of a picture stand for.
struct Legend {
  std::string title;                ///< "Stretch along the warp"; drawn in capitals
  std::string unit;                 ///< "%"
  std::vector<Rgb8> colours;        ///< of bands that follow each other
  std::vector<std::string> bounds;  ///< where the bands begin and the last ends: one more than colours
};

/// In the lower left corner of a picture, as wide as half of it.
void draw_legend(Image& image, const Legend& legend);

}  // namespace toile::render
