#pragma once

#include <string>

#include "core/image/picture.h"

namespace toile::test {

struct JpegWishes {
  int quality = 95;
  bool progressive = false;
  bool grey = false;
  bool inks = false;    ///< CMYK as Adobe's programs write it
  int orientation = 0;  ///< an EXIF segment that says so; 0: none
};

/// The picture as a JPEG file, colours at full resolution.
std::string jpeg_of(const image::Picture& picture, const JpegWishes& wishes = {});

}  // namespace toile::test
