#include "garment_picture.h"

#include "core/base/write_file.h"
#include "server/render/still.h"
#include "tests/core/image/jpegs.h"

namespace toile::bench {

Result<image::Picture> picture_of(const drape::DrapeInput& input, const drape::DrapeResult& result,
                                  render::View view, int width, int height) {
  render::Scene scene;
  scene.cloth = {result.positions,
                 result.garment.triangles,
                 result.garment.panel_of_triangle,
                 result.garment.weld,
                 {},
                 result.garment.rest,
                 nullptr};
  for (const Index fabric : input.fabric_of_panel) {
    const double* colour = input.fabrics[static_cast<std::size_t>(fabric)].colour;
    scene.cloth.colour_of_panel.push_back({colour[0], colour[1], colour[2]});
  }
  for (const body::Body& body : input.bodies) scene.bodies.push_back({.mesh = &body.mesh});
  const render::Image still = TRY(render::Stills().render(scene, view, {width, height}));
  image::Picture picture{width, height, {}, true};
  for (std::size_t i = 0; i < still.rgb.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) picture.rgba.push_back(still.rgb[i + k]);
    picture.rgba.push_back(255);
  }
  return picture;
}

image::Picture side_by_side(const std::vector<image::Picture>& pictures) {
  image::Picture all;
  for (const image::Picture& p : pictures) all.width += p.width;
  all.height = pictures.empty() ? 0 : pictures.front().height;
  for (int row = 0; row < all.height; ++row) {
    for (const image::Picture& p : pictures) {
      const auto from = p.rgba.begin() + std::ptrdiff_t{4} * row * p.width;
      all.rgba.insert(all.rgba.end(), from, from + std::ptrdiff_t{4} * p.width);
    }
  }
  return all;
}

Status write_jpeg(const std::filesystem::path& path, const image::Picture& picture) {
  return write_file(path, test::jpeg_of(picture, {.quality = 82}));
}

}  // namespace toile::bench
