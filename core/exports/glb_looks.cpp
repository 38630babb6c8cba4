#include "core/exports/glb_looks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/image/write_png.h"

namespace toile::exports {
namespace {

Result<GlbImage> image_of(const image::TextureImage& image, const material::Fabric& fabric) {
  const image::ReadPicture& read = image.read;
  // The file itself, where a viewer would show just what we do: no second compression.
  if (read.plain && read.picture.opaque)
    return GlbImage{image.name, std::string(image::media_type(read.format)), image.bytes};
  const double* const c = fabric.colour;
  const image::Picture shown = image::over_ground(read.picture, {c[0], c[1], c[2]});
  std::vector<std::uint8_t> rgb;
  rgb.reserve(shown.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < shown.rgba.size(); i += 4)
    rgb.insert(rgb.end(), {shown.rgba[i], shown.rgba[i + 1], shown.rgba[i + 2]});
  std::string bytes = TRY(image::encode_png(shown.width, shown.height, 3, rgb));
  return GlbImage{image.name, std::string(image::media_type(image::PictureFormat::kPng)), std::move(bytes)};
}

/// Index into looks.looks, made when there is none yet. An opaque picture is one image for all fabrics.
Result<int> look_for(const image::TextureImage& image, Index picture, Index fabric,
                     const material::Fabric& cloth, GlbLooks& looks) {
  const auto is_it = [&](const GlbLook& look) { return look.fabric == fabric && look.picture == picture; };
  const auto known = std::find_if(looks.looks.begin(), looks.looks.end(), is_it);
  if (known != looks.looks.end()) return static_cast<int>(known - looks.looks.begin());
  const auto same = [&](const GlbLook& look) { return look.picture == picture && image.read.picture.opaque; };
  const auto shared = std::find_if(looks.looks.begin(), looks.looks.end(), same);
  int index = static_cast<int>(looks.images.size());
  if (shared != looks.looks.end()) {
    index = shared->image;
  } else {
    GlbImage made = TRY(image_of(image, cloth));
    looks.images.push_back(std::move(made));
  }
  looks.looks.push_back({fabric, picture, index});
  return static_cast<int>(looks.looks.size()) - 1;
}

}  // namespace

Result<GlbLooks> glb_looks(const image::Textures& textures, std::span<const Index> fabric_of_panel,
                           std::span<const material::Fabric> fabrics) {
  GlbLooks looks;
  for (std::size_t p = 0; p < fabric_of_panel.size(); ++p) {
    looks.look_of_panel.push_back(kNone);
    const image::PanelTexture* const texture = image::texture_of(textures, static_cast<Index>(p));
    if (texture == nullptr) continue;
    if (texture->image < 0 || static_cast<std::size_t>(texture->image) >= textures.images.size()) {
      return Error{"export.bad_index", "a panel names a picture that is not there",
                   "panel " + std::to_string(p), ErrorKind::kInternal};
    }
    const image::TextureImage& image = *textures.images[static_cast<std::size_t>(texture->image)];
    const Index fabric = fabric_of_panel[p];
    looks.look_of_panel.back() =
        TRY(look_for(image, texture->image, fabric, fabrics[static_cast<std::size_t>(fabric)], looks));
  }
  return looks;
}

std::vector<Vec2> glb_coordinates(const image::PanelTexture& texture, std::span<const Vec2> rest) {
  std::vector<Vec2> out;
  out.reserve(rest.size());
  for (const Vec2 flat : rest) {
    const Vec2 at = image::texture_at(texture, flat);
    // glTF counts down from a picture's upper rim, we up from the lower one.
    out.push_back({at.x, 1 - at.y});
  }
  return out;
}

}  // namespace toile::exports
