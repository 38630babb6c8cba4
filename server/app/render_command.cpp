#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "core/base/read_file.h"
#include "core/exports/map_file.h"
#include "core/json/tree.h"
#include "server/app/commands.h"
#include "server/app/console.h"
#include "server/app/read_film.h"
#include "server/movie/film_still.h"
#include "server/render/png.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

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

Result<movie::StillWish> wish_of(const RenderOptions& options) {
  movie::StillWish wish;
  TRY(read_size(options.size, wish.settings));
  wish.settings.samples = options.samples;
  wish.settings.transparent = options.transparent;
  wish.map = options.map;
  if (options.eye.empty()) {
    wish.from = TRY(render::view_from(options.view));
    return wish;
  }
  render::Viewpoint from;
  from.eye = TRY(read_place(options.eye, "--eye"));
  if (!options.target.empty()) from.target = TRY(read_place(options.target, "--target"));
  if (options.angle) from.angle = *options.angle;
  wish.from = from;
  return wish;
}

/// The maps.json that toile drape leaves beside its film. Error: usage.map.
Result<std::string> maps_beside(const fs::path& source) {
  std::error_code ignored;
  const fs::path path =
      (fs::is_directory(source, ignored) ? source : source.parent_path()) / exports::kMapFile;
  std::optional<std::string> text = read_file(path);
  if (text) return std::move(*text);
  return Error{"usage.map", "cannot read the maps that toile drape leaves beside its film; drape anew",
               path.string()};
}

Result<render::Image> take(const RenderOptions& options) {
  const movie::StillWish wish = TRY(wish_of(options));
  TRY(movie::check_wish(wish));
  const movie::Film film = TRY(read_film(options.source));
  render::Stills stills;
  return movie::take_still(
      film, wish, [&] { return maps_beside(options.source); }, stills);
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
