#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/result.h"

namespace toile::image {

/// What the compression looks for. Pictures with noise in them hardly repeat themselves: to look for runs
/// alone makes a still's file 2 % larger, in a seventh of the time.
enum class PngMatches { kAny, kRuns };

/// A PNG file's bytes, marked as sRGB. `pixels` has rows from the top of `channels` bytes a pixel: 3 (RGB) or
/// 4 (with opacity). Error: "image.bad_size" when they do not fit the width and height.
Result<std::string> encode_png(int width, int height, int channels, std::span<const std::uint8_t> pixels,
                               PngMatches matches = PngMatches::kAny);

}  // namespace toile::image
