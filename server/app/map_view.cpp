#include "server/app/map_view.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <vector>

#include "core/analysis/cloth_map.h"
#include "core/base/read_file.h"
#include "core/base/rounded.h"
#include "core/base/text.h"
#include "core/exports/map_file.h"
#include "core/image/picture.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

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

Result<std::vector<analysis::ClothMap>> maps_of(const fs::path& result) {
  std::error_code ignored;
  const fs::path path =
      (fs::is_directory(result, ignored) ? result : result.parent_path()) / exports::kMapFile;
  const std::optional<std::string> text = read_file(path);
  if (!text)
    return Error{"usage.map", "cannot read the maps that toile drape leaves beside its film; drape anew",
                 path.string()};
  Result<std::vector<analysis::ClothMap>> maps = exports::parse_maps(*text);
  if (!maps) return placed_at(maps.error(), path.string());
  return maps;
}

}  // namespace

Result<render::Legend> colour_by_map(const fs::path& result, const std::string& word, render::Scene& scene) {
  const analysis::MapKind kind = TRY(analysis::map_kind_from(word));
  const std::vector<analysis::ClothMap> maps = TRY(maps_of(result));
  const auto map =
      std::find_if(maps.begin(), maps.end(), [&](const analysis::ClothMap& one) { return one.kind == kind; });
  if (map == maps.end())
    return Error{"map.absent", "this drape has no such map: there is no body that it could be measured to",
                 word};
  if (map->values.size() != scene.cloth.positions.size())
    return Error{"map.other_drape", "the maps are of another cloth than the film", result.string()};
  const analysis::MapScale scale = analysis::scale_of(*map);
  for (const float value : map->values)
    scene.cloth.colour_of_vertex.push_back(light_at(scale.place(static_cast<double>(value))));
  scene.cloth.textures = nullptr;
  for (render::ClothLook& look : scene.cloth.look_of_panel)
    look = {.thickness = look.thickness, .sheen = 0, .uneven = 0};
  return legend_of(scale);
}

}  // namespace toile::app
