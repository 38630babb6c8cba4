#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "server/movie/film.h"

namespace toile::app {

/// The film of what a drape has left: its folder, the film itself, or a trace, which shows nothing but the
/// cloth. Errors: usage.film, film.*, trace.*.
Result<movie::Film> read_film(std::filesystem::path path);

/// The frames of a trace. Errors: trace.*.
Result<movie::Motion> read_motion(const std::filesystem::path& trace);

}  // namespace toile::app
