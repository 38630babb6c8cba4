#pragma once
// A drape coloured by what its cloth is measured for.

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "server/render/legend.h"
#include "server/render/scene.h"

namespace toile::movie {

/// Colours the scene's cloth by the map of that word, from a drape's maps.json, and gives back what the
/// colours stand for. Pictures and threads are left out: they would be taken for values. Errors: map.damaged,
/// map.unknown, map.absent (there is no body to measure to), map.other_drape (it is of another cloth).
Result<render::Legend> colour_by_map(std::string_view maps_file, const std::string& word,
                                     render::Scene& scene);

}  // namespace toile::movie
