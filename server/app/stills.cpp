#include "server/app/stills.h"

#include <string>
#include <utility>

#include "server/render/png.h"
#include "server/render/still.h"

namespace toile {
namespace {

Scene scene_of(const DrapeInput& input, const DrapeResult& result) {
  Scene scene;
  scene.cloth.positions = result.positions;
  scene.cloth.triangles = result.garment.triangles;
  scene.cloth.panel_of_triangle = result.garment.panel_of_triangle;
  scene.cloth.weld = result.garment.weld;
  scene.cloth.rest = result.garment.rest;
  for (const Index fabric : input.fabric_of_panel) {
    const double* colour = input.fabrics[static_cast<std::size_t>(fabric)].colour;
    scene.cloth.colour_of_panel.push_back({colour[0], colour[1], colour[2]});
  }
  for (const Body& body : input.bodies) scene.bodies.push_back({.mesh = &body.mesh});
  return scene;
}

}  // namespace

Status write_stills(const DrapeInput& input, const DrapeResult& result, const std::filesystem::path& folder,
                    int width, int height) {
  const Scene scene = scene_of(input, result);
  StillSettings settings;
  settings.width = width;
  settings.height = height;
  for (const auto& [view, name] :
       {std::pair{View::kFront, "front"}, std::pair{View::kBack, "back"}, std::pair{View::kSide, "side"},
        std::pair{View::kThreeQuarter, "three-quarter"}}) {
    const Result<Image> image = render_still(scene, view, settings);
    if (!image) return image.error();
    if (Status written = write_png(folder / (std::string(name) + ".png"), *image); !written) return written;
  }
  return {};
}

}  // namespace toile
