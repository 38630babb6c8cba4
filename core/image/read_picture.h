#pragma once
// PNG and JPEG files into pixels, for pictures on cloth. Files come from strangers: what a file is tells its
// first bytes, never its name, and limits hold before memory is taken.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/image/picture.h"

namespace toile::image {

enum class PictureFormat { kPng, kJpeg };

/// "image/png", "image/jpeg".
std::string_view media_type(PictureFormat format);

/// What the first bytes say; nothing when it is neither.
std::optional<PictureFormat> picture_format(std::string_view bytes);

struct PictureLimits {
  std::size_t bytes = std::size_t{20} << 20;
  int side = 16384;                              ///< pixels of the file, along its longer side
  std::int64_t pixels = std::int64_t{64} << 20;  ///< of the file
  /// Of a file that can only be read as a whole (interlaced PNG, progressive JPEG).
  std::int64_t whole_pixels = std::int64_t{16} << 20;
  int scans = 100;        ///< of a progressive JPEG: each costs as much as a picture
  int shown_side = 2048;  ///< a larger picture is reduced, each pixel a mean of squares of the file's
};

struct ReadPicture {
  PictureFormat format = PictureFormat::kPng;
  int width = 0, height = 0;  ///< of the file, as it is shown
  Picture picture;            ///< at most PictureLimits::shown_side a side
  /// The file's own bytes show the same to a reader that knows nothing of cameras that were held upright,
  /// printers' colours or 16 bits: it was neither turned nor reduced.
  bool plain = true;
};

/// Errors, with nothing in `where`: image.format (neither PNG nor JPEG), image.too_large (bytes, pixels or
/// scans), image.truncated (it ends early), image.damaged (with the library's words).
Result<ReadPicture> read_picture(std::string_view bytes, const PictureLimits& limits = {});

}  // namespace toile::image
