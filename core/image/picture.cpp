#include "core/image/picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace toile::image {

double linear_from_srgb(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

double srgb_from_linear(double c) {
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

Picture turned(Picture picture, int orientation) {
  if (orientation < 2 || orientation > 8) return picture;
  // Where the shown picture's pixel (x, y) lies in the stored one, by the tag's table.
  const bool swapped = orientation >= 5;
  const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool from_below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Picture out{
      swapped ? picture.height : picture.width, swapped ? picture.width : picture.height, {}, picture.opaque};
  out.rgba.resize(picture.rgba.size());
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const int across = swapped ? y : x, down = swapped ? x : y;
      const int column = from_right ? picture.width - 1 - across : across;
      const int row = from_below ? picture.height - 1 - down : down;
      const std::size_t from = (static_cast<std::size_t>(row) * picture.width + column) * 4;
      std::copy_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(from), 4,
                  out.rgba.begin() + (static_cast<std::ptrdiff_t>(y) * out.width + x) * 4);
    }
  }
  return out;
}

Picture over_ground(Picture picture, const std::array<double, 3>& ground) {
  if (picture.opaque) return picture;
  std::array<double, 256> linear;
  for (int i = 0; i < 256; ++i) linear[i] = linear_from_srgb(i / 255.0);
  for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    std::uint8_t* const pixel = &picture.rgba[i];
    if (pixel[3] == 255) continue;
    const double share = pixel[3] / 255.0;
    for (int c = 0; c < 3; ++c) {
      // Light adds up, the numbers of sRGB do not: mixed as they are, rims come out dark.
      const double light = share * linear[pixel[c]] + (1 - share) * std::clamp(ground[c], 0.0, 1.0);
      pixel[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(srgb_from_linear(light), 0.0, 1.0)));
    }
    pixel[3] = 255;
  }
  picture.opaque = true;
  return picture;
}

}  // namespace toile::image
