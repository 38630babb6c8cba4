#pragma once
// A drawing as a picture: SVG through ffmpeg's reader of it (librsvg), in a child on a leash as movies are.

#include <filesystem>

#include "core/base/result.h"

namespace toile::movie {

/// Draws the SVG file, `width` pixels wide, on white into a PNG file. Errors: movie.no_ffmpeg when ffmpeg is
/// not installed, movie.failed.
Status draw_svg(const std::filesystem::path& svg, const std::filesystem::path& png, int width);

}  // namespace toile::movie
