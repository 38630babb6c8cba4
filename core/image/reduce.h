#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/image/picture.h"

namespace toile::image {

/// The picture `width` pixels wide and as high as its shape asks for (at least 1), each pixel the mean of
/// what it covers; as it is where it is no wider. REQUIRES width > 0.
Picture reduced(const Picture& picture, int width);

/// A PNG or JPEG file's picture as a PNG file of that width. Errors: those of read_picture.
Result<std::string> reduced_png(std::string_view bytes, int width);

}  // namespace toile::image
