#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace toile::image {

/// Pixels as they are shown: 8-bit sRGB, four bytes each (red, green, blue, opacity), rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  bool opaque = true;  ///< every opacity is 255
  friend bool operator==(const Picture&, const Picture&) = default;
};

/// Light of a number of sRGB, and back, both 0 to 1 (IEC 61966-2-1).
double linear_from_srgb(double c);
double srgb_from_linear(double c);

/// A picture turned as a camera says how it was held: 1 to 8, the numbers of EXIF's tag Orientation; any
/// other leaves it. From 5 on width and height change places.
Picture turned(Picture picture, int orientation);

/// What is seen of `picture` on a ground of one colour (linear RGB, 0 to 1): opaque.
Picture over_ground(Picture picture, const std::array<double, 3>& ground);

}  // namespace toile::image
