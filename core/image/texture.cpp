#include "core/image/texture.h"

#include <cmath>
#include <cstddef>

namespace toile::image {

PanelTexture lay_texture(Index image, Vec2 grain, Vec2 origin_m, double width_m, double aspect,
                         double angle) {
  // Rows along which texture_at measures: one width, and one height, of the picture are 1.
  const Vec2 up = std::cos(angle) * grain + std::sin(angle) * perpendicular(grain);
  return {image, origin_m, -perpendicular(up) * (1 / width_m), up * (aspect / width_m)};
}

Vec2 texture_at(const PanelTexture& texture, Vec2 flat) {
  const Vec2 from = flat - texture.origin;
  return {dot(from, texture.across), dot(from, texture.up)};
}

const PanelTexture* texture_of(const Textures& textures, Index panel) {
  if (panel < 0 || static_cast<std::size_t>(panel) >= textures.of_panel.size()) return nullptr;
  const std::optional<PanelTexture>& found = textures.of_panel[static_cast<std::size_t>(panel)];
  return found ? &*found : nullptr;
}

}  // namespace toile::image
