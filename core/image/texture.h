#pragma once
// Pictures on cloth: which lies where on which piece. Looks only; no drape depends on them.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/types.h"
#include "core/image/read_picture.h"

namespace toile::image {

/// A picture file that pieces show.
struct TextureImage {
  std::string name;   ///< of the file
  std::string bytes;  ///< of the file
  ReadPicture read;
};

/// How a picture lies on a flat piece, repeated without end.
struct PanelTexture {
  Index image = 0;  ///< index into Textures::images
  Vec2 origin;      ///< m, a lower left corner of the picture on the flat piece
  Vec2 across, up;  ///< repeats per metre along the picture's width and height; perpendicular
};

/// A picture of `aspect` = width / height, one repeat `width_m` wide, its upright turned counter-clockwise by
/// `angle` (radians) from the warp, so that it lies on the piece as it does on the bale. REQUIRES a grain of
/// length 1, width_m > 0 and aspect > 0.
PanelTexture lay_texture(Index image, Vec2 grain, Vec2 origin_m, double width_m, double aspect, double angle);

/// Repeats to the right (x) and up (y) of the picture's lower left corner, for a flat point of the piece, m.
Vec2 texture_at(const PanelTexture& texture, Vec2 flat);

struct Textures {
  std::vector<std::shared_ptr<const TextureImage>> images;
  std::vector<std::optional<PanelTexture>> of_panel;  ///< one per panel; those past the end have none
};

/// The panel's texture, or null.
const PanelTexture* texture_of(const Textures& textures, Index panel);

}  // namespace toile::image
