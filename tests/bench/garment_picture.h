#pragma once
// Small pictures of draped garments, for documents.

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/drape/drape_input.h"
#include "core/drape/drape_result.h"
#include "core/image/picture.h"
#include "server/render/camera.h"

namespace toile::bench {

/// As a still shows it from there.
Result<image::Picture> picture_of(const drape::DrapeInput& input, const drape::DrapeResult& result,
                                  render::View view, int width, int height);

/// Equally high pictures, side by side.
image::Picture side_by_side(const std::vector<image::Picture>& pictures);

/// As a JPEG file.
Status write_jpeg(const std::filesystem::path& path, const image::Picture& picture);

}  // namespace toile::bench
