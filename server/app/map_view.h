#pragma once
// A drape coloured by what its cloth is measured for.

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "server/render/legend.h"
#include "server/render/scene.h"

namespace toile::app {

/// Colours the scene's cloth by the map of that word, from the maps.json that toile drape left in `result`,
/// and gives back what the colours stand for. Pictures and threads are left out: they would be taken for
/// values. Errors: usage.map (no such file), map.damaged, map.unknown, map.absent (there is no body to
/// measure to), map.other_drape (it is of another cloth).
Result<render::Legend> colour_by_map(const std::filesystem::path& result, const std::string& word,
                                     render::Scene& scene);

}  // namespace toile::app
