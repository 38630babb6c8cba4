#pragma once
// Stills of how a drape ended, from anywhere, as it looks or coloured by a map.

#include <functional>
#include <string>
#include <variant>

#include "core/base/result.h"
#include "server/movie/film.h"
#include "server/render/still.h"

namespace toile::movie {

/// What somebody wants a picture of.
struct StillWish {
  std::variant<render::View, render::Viewpoint> from = render::View::kThreeQuarter;
  render::StillSettings settings;
  std::string map;  ///< word of what the cloth is coloured by; empty: as it looks
};

/// Errors: render.settings, render.camera, map.unknown.
Status check_wish(const StillWish& wish);

/// The drape's maps.json.
using MapsFile = std::function<Result<std::string>()>;

/// `maps_file` is asked only where a map is wished for. Errors: those of check_wish, colour_by_map, render.*
/// and of `maps_file`.
Result<render::Image> take_still(const Film& film, const StillWish& wish, const MapsFile& maps_file,
                                 render::Stills& stills);

}  // namespace toile::movie
