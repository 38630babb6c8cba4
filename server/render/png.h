#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "server/render/still.h"

namespace toile::render {

/// The image as a PNG file's bytes, marked as sRGB. Error: "render.bad_image" when its arrays do not fit.
Result<std::string> png_bytes(const Image& image);

/// Writes png_bytes to `path`. Errors: that, and "export.write" with the path and the system's reason.
Status write_png(const std::filesystem::path& path, const Image& image);

}  // namespace toile::render
