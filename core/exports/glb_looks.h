#pragma once
// What panels with a picture on them look like in a glTF file: one material for each fabric and picture.

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/texture.h"
#include "core/material/fabric.h"

namespace toile::exports {

/// An image file within the .glb.
struct GlbImage {
  std::string name, media_type, bytes;
};

/// A fabric with a picture on it.
struct GlbLook {
  Index fabric = kNone;
  Index picture = kNone;  ///< index into Textures::images
  int image = 0;          ///< index into GlbLooks::images
};

struct GlbLooks {
  std::vector<GlbImage> images;
  std::vector<GlbLook> looks;
  std::vector<int> look_of_panel;  ///< index into looks; kNone: its fabric's colour alone
};

/// Looks in the order of the panels. The file's own bytes are kept where every reader shows them as they are
/// meant; a picture that was turned, reduced or of printers' colours becomes a PNG of what is shown, and one
/// that is not opaque lies over its fabric's colour. REQUIRES fabrics of panels within `fabrics`. Errors:
/// "export.bad_index" (a panel's picture is not there), "image.bad_size".
Result<GlbLooks> glb_looks(const image::Textures& textures, std::span<const Index> fabric_of_panel,
                           std::span<const material::Fabric> fabrics);

/// Texture coordinates of glTF, down from a picture's upper left corner, for flat points of a panel, m.
std::vector<Vec2> glb_coordinates(const image::PanelTexture& texture, std::span<const Vec2> rest);

}  // namespace toile::exports
