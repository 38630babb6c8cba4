#pragma once
// Pictures made by code, and as files.

#include <cstdint>
#include <functional>
#include <string>

#include "core/image/picture.h"
#include "core/image/write_png.h"

namespace toile::test {

inline image::Picture painted(int width, int height,
                              const std::function<std::array<int, 4>(int, int)>& colour) {
  image::Picture picture{width, height, {}, true};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const int channel : colour(x, y)) picture.rgba.push_back(static_cast<std::uint8_t>(channel));
      picture.opaque &= picture.rgba.back() == 255;
    }
  }
  return picture;
}

/// Two by two squares: red and white above, white and blue below.
inline image::Picture squares(int side = 16) {
  return painted(side, side, [=](int x, int y) -> std::array<int, 4> {
    const bool right = x >= side / 2, low = y >= side / 2;
    if (right != low) return {250, 250, 250, 255};
    return right ? std::array<int, 4>{20, 40, 200, 255} : std::array<int, 4>{200, 30, 20, 255};
  });
}

inline std::string png_of(const image::Picture& picture) {
  return image::encode_png(picture.width, picture.height, 4, picture.rgba).value();
}

}  // namespace toile::test
