#include "server/movie/film_still.h"

#include <string>
#include <variant>

#include "core/analysis/cloth_map.h"
#include "server/movie/map_colours.h"
#include "server/render/legend.h"

namespace toile::movie {
namespace {

Result<render::Camera> camera_of(const StillWish& wish, const render::Scene& scene) {
  const double aspect = static_cast<double>(wish.settings.width) / wish.settings.height;
  if (const auto* view = std::get_if<render::View>(&wish.from))
    return render::frame_scene(scene, *view, aspect);
  return render::camera_at(scene, std::get<render::Viewpoint>(wish.from), aspect);
}

}  // namespace

Status check_wish(const StillWish& wish) {
  TRY(render::check_settings(wish.settings));
  if (!wish.map.empty()) TRY(analysis::map_kind_from(wish.map));
  const auto* own = std::get_if<render::Viewpoint>(&wish.from);
  return own == nullptr ? Status() : render::check_viewpoint(*own);
}

Result<render::Image> take_still(const Film& film, const StillWish& wish, const MapsFile& maps_file,
                                 render::Stills& stills) {
  TRY(check_wish(wish));
  render::Scene scene = scene_of(film, film.end);
  render::Legend legend;
  if (!wish.map.empty()) {
    const std::string maps = TRY(maps_file());
    legend = TRY(colour_by_map(maps, wish.map, scene));
  }
  TRY(render::check_scene(scene));
  const render::Camera camera = TRY(camera_of(wish, scene));
  render::Image image = TRY(stills.render(scene, camera, wish.settings));
  render::draw_legend(image, legend);
  return image;
}

}  // namespace toile::movie
