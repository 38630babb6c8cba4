#pragma once
// Films as bytes (proto/film.md).

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "server/movie/film.h"

namespace toile::movie {

inline constexpr std::uint32_t kFilmVersion = 3;
/// The name of a drape's film among its results.
inline constexpr const char* kFilmFile = "drape.film";

std::string encode_film(const Film& film);

/// Errors: film.damaged (cut off, changed, no film at all), film.version. What it gives back is whole:
/// indices in range, numbers finite, all lengths agree. Takes memory in proportion to the bytes.
Result<Film> decode_film(std::string_view bytes);

/// The motion alone, as it stands within a film.
std::string encode_motion(const Motion& motion);
/// Error: film.damaged.
Result<Motion> decode_motion(std::string_view bytes);

}  // namespace toile::movie
