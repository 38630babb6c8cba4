#pragma once
// Rows of a file as they are decoded, into a picture of a size that was asked for.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/image/picture.h"
#include "core/image/read_picture.h"

namespace toile::image {

/// Whether a file of this size may be read. Error: image.too_large.
Status check_size(std::int64_t width, std::int64_t height, bool whole, const PictureLimits& limits);

/// Takes rows from the top and keeps means of squares of pixels; opacity weighs the colours.
class PictureRows {
 public:
  PictureRows(int width, int height, int shown_side);
  /// `row` has width pixels of four bytes.
  void add(std::span<const std::uint8_t> row);
  bool reduced() const { return factor_ > 1; }
  /// REQUIRES as many rows as the height said.
  Picture take();

 private:
  void close_row();

  int width_, height_, factor_;
  int rows_ = 0;                     // so far
  std::vector<std::uint64_t> sums_;  // of the row of squares under way: r·a, g·a, b·a, a
  Picture picture_;
};

}  // namespace toile::image
