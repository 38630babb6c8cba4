#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/image/read_picture.h"

namespace toile::image {

/// read_picture for a file that begins as a JPEG: grey, YCbCr, RGB, and CMYK of printers. It is turned as the
/// camera says that it was held.
Result<ReadPicture> read_jpeg(std::string_view bytes, const PictureLimits& limits);

}  // namespace toile::image
