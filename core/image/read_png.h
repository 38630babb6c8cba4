#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/image/read_picture.h"

namespace toile::image {

/// read_picture for a file that begins as a PNG. Colours are taken for sRGB; of 16 bits the upper 8 count.
Result<ReadPicture> read_png(std::string_view bytes, const PictureLimits& limits);

}  // namespace toile::image
