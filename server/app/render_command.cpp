#include <cstdio>
#include <string>

#include "core/json/tree.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/map_view.h"
#include "server/app/read_film.h"
#include "server/render/png.h"
#include "server/render/still.h"

namespace toile::app {
namespace {

Status read_size(const std::string& text, render::StillSettings& settings) {
  if (text.empty()) return {};
  int used = 0;
  const bool whole = std::sscanf(text.c_str(), "%5dx%5d%n", &settings.width, &settings.height, &used) == 2 &&
                     used == static_cast<int>(text.size());
  if (whole) return {};
  return Error{"render.settings", "a size is WIDTHxHEIGHT in pixels, e.g. 1024x1280", "--size"};
}

Result<Vec3> read_place(const std::string& text, const char* option) {
  Vec3 p;
  int used = 0;
  const bool whole = std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &p.x, &p.y, &p.z, &used) == 3 &&
                     used == static_cast<int>(text.size());
  if (whole) return p;
  return Error{"render.camera", "a place is X,Y,Z in metres, e.g. 0,1.2,1.5", option};
}

Result<render::Camera> camera_of(const RenderOptions& options, const render::Scene& scene, double aspect) {
  if (options.eye.empty()) {
    const render::View view = TRY(render::view_from(options.view));
    return render::frame_scene(scene, view, aspect);
  }
  render::Viewpoint from;
  from.eye = TRY(read_place(options.eye, "--eye"));
  if (!options.target.empty()) from.target = TRY(read_place(options.target, "--target"));
  if (options.angle) from.angle = *options.angle;
  return render::camera_at(scene, from, aspect);
}

Result<render::Image> take(const RenderOptions& options) {
  render::StillSettings settings;
  TRY(read_size(options.size, settings));
  settings.samples = options.samples;
  settings.transparent = options.transparent;
  TRY(render::check_settings(settings));
  const movie::Film film = TRY(read_film(options.source));
  render::Scene scene = movie::scene_of(film, film.end);
  render::Legend legend;
  if (!options.map.empty()) legend = TRY(colour_by_map(options.source, options.map, scene));
  TRY(render::check_scene(scene));
  const render::Camera camera =
      TRY(camera_of(options, scene, static_cast<double>(settings.width) / settings.height));
  const std::unique_ptr<render::StillRenderer> renderer = TRY(render::StillRenderer::create());
  render::Image image = TRY(renderer->render(scene, camera, settings));
  render::draw_legend(image, legend);
  return image;
}

void print_taken(const render::Image& image, const RenderOptions& options) {
  if (!options.json) {
    std::printf("%s: %d x %d\n", options.out.c_str(), image.width, image.height);
    return;
  }
  const json::JsonValue told(std::vector<json::JsonMember>{{"file", options.out},
                                                           {"width", static_cast<double>(image.width)},
                                                           {"height", static_cast<double>(image.height)}});
  std::printf("%s", json::write_json(told).c_str());
}

}  // namespace

ExitCode render_command(const RenderOptions& options) {
  const Result<render::Image> image = take(options);
  if (!image) return fail(image.error(), options.json);
  if (Status written = render::write_png(options.out, *image); !written)
    return fail(written.error(), options.json);
  print_taken(*image, options);
  return kDone;
}

}  // namespace toile::app
