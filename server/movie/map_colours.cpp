#include "server/movie/map_colours.h"

#include <algorithm>
#include <vector>

#include "core/analysis/cloth_map.h"
#include "core/base/rounded.h"
#include "core/base/text.h"
#include "core/exports/map_file.h"
#include "core/image/picture.h"

namespace toile::movie {
namespace {

/// Between the colours of two bands: at vertices, steps would run along the triangles' edges as teeth.
render::LinearRgb light_at(double place) {
  const auto& colours = analysis::band_colours();
  const auto from = static_cast<std::size_t>(place), to = std::min(from + 1, colours.size() - 1);
  const double share = place - static_cast<double>(from);
  render::LinearRgb out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = (1 - share) * image::linear_from_srgb(colours[from][c] / 255.0) +
             share * image::linear_from_srgb(colours[to][c] / 255.0);
  return out;
}

render::Legend legend_of(const analysis::MapScale& scale) {
  const analysis::MapTrait& trait = analysis::trait_of(scale.kind);
  const auto& colours = analysis::band_colours();
  render::Legend legend{
      std::string(trait.title), std::string(trait.unit), {colours.begin(), colours.end()}, {}};
  for (const double bound : scale.bounds()) legend.bounds.push_back(number_text(rounded(bound, 3)));
  return legend;
}

}  // namespace

Result<render::Legend> colour_by_map(std::string_view maps_file, const std::string& word,
                                     render::Scene& scene) {
  const analysis::MapKind kind = TRY(analysis::map_kind_from(word));
  const std::vector<analysis::ClothMap> maps = TRY(exports::parse_maps(maps_file));
  const auto map =
      std::find_if(maps.begin(), maps.end(), [&](const analysis::ClothMap& one) { return one.kind == kind; });
  if (map == maps.end())
    return Error{"map.absent", "this drape has no such map: there is no body that it could be measured to",
                 word};
  if (map->values.size() != scene.cloth.positions.size())
    return Error{"map.other_drape", "the maps are of another cloth than the film", word};
  const analysis::MapScale scale = analysis::scale_of(*map);
  for (const float value : map->values)
    scene.cloth.colour_of_vertex.push_back(light_at(scale.place(static_cast<double>(value))));
  scene.cloth.textures = nullptr;
  for (render::ClothLook& look : scene.cloth.look_of_panel)
    look = {.thickness = look.thickness, .sheen = 0, .uneven = 0};
  return legend_of(scale);
}

}  // namespace toile::movie
