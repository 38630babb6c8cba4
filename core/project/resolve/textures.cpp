#include "core/project/resolve/textures.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/names.h"
#include "core/base/units.h"
#include "core/json/tree.h"

namespace toile::resolve {
namespace {

constexpr std::size_t kFewImages = 4;
constexpr int kSideOfFew = 2048, kSideOfMany = 1024;  // pixels

Error too_many(const std::string& where) {
  return {"image.too_many",
          "a project shows at most " + std::to_string(kMostTextureImages) + " different pictures of " +
              std::to_string(kMostTextureBytes >> 20) + " MiB together",
          where};
}

/// A picture's name and the first place that names it.
struct NamedImage {
  std::string name, where;
};

std::vector<NamedImage> images_of(const project::Project& project) {
  std::vector<NamedImage> images;
  for (std::size_t i = 0; i < project.pieces.size(); ++i) {
    const project::ProjectPiece& piece = project.pieces[i];
    if (!piece.texture) continue;
    const auto same = [&](const NamedImage& one) { return one.name == piece.texture->image; };
    if (std::any_of(images.begin(), images.end(), same)) continue;
    const std::string texture = json::pointer_to(json::pointer_to("/pieces", i), "texture");
    images.push_back({piece.texture->image, json::pointer_to(texture, "image")});
  }
  return images;
}

Result<std::shared_ptr<const image::TextureImage>> read_image(const NamedImage& named,
                                                              const ProjectFiles& files, int side) {
  if (!files.image_bytes) return Error{"project.file", "there are no pictures here", named.where};
  Result<std::string> bytes = files.image_bytes(named.name);
  if (!bytes) return json::error_at(named.where, bytes.error());
  Result<image::ReadPicture> read = image::read_picture(*bytes, {.shown_side = side});
  if (!read) {
    Error error = read.error();
    error.message = in_quotes(named.name) + ": " + error.message;
    return json::error_at(named.where, std::move(error));
  }
  return std::make_shared<const image::TextureImage>(
      image::TextureImage{named.name, std::move(*bytes), std::move(*read)});
}

image::PanelTexture lay(const project::ProjectTexture& texture, Index image,
                        const image::ReadPicture& picture, Vec2 grain) {
  const Vec2 origin{metres_from_mm(texture.offset.x), metres_from_mm(texture.offset.y)};
  return image::lay_texture(image, grain, origin, metres_from_mm(texture.scale_mm),
                            static_cast<double>(picture.width) / picture.height,
                            radians_from_degrees(texture.angle));
}

}  // namespace

Result<image::Textures> read_textures(const project::Project& project, const pattern::Pattern& pattern,
                                      const ProjectFiles& files) {
  const std::vector<NamedImage> images = images_of(project);
  if (images.size() > kMostTextureImages) return too_many(images[kMostTextureImages].where);
  image::Textures textures;
  std::map<std::string, Index> index;
  std::size_t bytes = 0;
  for (const NamedImage& named : images) {
    auto image = TRY(read_image(named, files, images.size() > kFewImages ? kSideOfMany : kSideOfFew));
    bytes += image->bytes.size();
    if (bytes > kMostTextureBytes) return too_many(named.where);
    index[named.name] = static_cast<Index>(textures.images.size());
    textures.images.push_back(std::move(image));
  }
  for (const pattern::Panel& panel : pattern.panels) {
    textures.of_panel.emplace_back();
    const auto piece = std::find_if(project.pieces.begin(), project.pieces.end(),
                                    [&](const project::ProjectPiece& p) { return p.id == panel.id; });
    if (piece == project.pieces.end() || !piece->texture) continue;
    const Index image = index.at(piece->texture->image);
    textures.of_panel.back() =
        lay(*piece->texture, image, textures.images[static_cast<std::size_t>(image)]->read, panel.grain);
  }
  return textures;
}

}  // namespace toile::resolve
