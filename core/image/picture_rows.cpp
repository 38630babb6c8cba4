#include "core/image/picture_rows.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace toile::image {

Status check_size(std::int64_t width, std::int64_t height, bool whole, const PictureLimits& limits) {
  const std::string size = std::to_string(width) + " by " + std::to_string(height) + " pixels";
  if (width < 1 || height < 1) return Error{"image.damaged", "the picture has " + size, ""};
  const std::int64_t most = whole ? limits.whole_pixels : limits.pixels;
  if (std::max(width, height) <= limits.side && width * height <= most) return {};
  return Error{"image.too_large",
               "the picture has " + size + "; at most " + std::to_string(limits.side) + " a side and " +
                   std::to_string(most >> 20) + " million are read; save it smaller",
               "", ErrorKind::kTooLarge};
}

PictureRows::PictureRows(int width, int height, int shown_side)
    : width_(width), height_(height), factor_((std::max(width, height) + shown_side - 1) / shown_side) {
  picture_.width = (width + factor_ - 1) / factor_;
  picture_.height = (height + factor_ - 1) / factor_;
  picture_.rgba.reserve(static_cast<std::size_t>(picture_.width) * picture_.height * 4);
  if (reduced()) sums_.assign(static_cast<std::size_t>(picture_.width) * 4, 0);
}

void PictureRows::add(std::span<const std::uint8_t> row) {
  ++rows_;
  if (!reduced()) {
    picture_.rgba.insert(picture_.rgba.end(), row.begin(), row.end());
    return;
  }
  for (int x = 0; x < width_; ++x) {
    const std::uint8_t* const pixel = &row[static_cast<std::size_t>(x) * 4];
    std::uint64_t* const sum = &sums_[static_cast<std::size_t>(x / factor_) * 4];
    // Colours count by how opaque they are: what is hidden must not tint the rim of what is seen.
    for (int c = 0; c < 3; ++c) sum[c] += static_cast<std::uint64_t>(pixel[c]) * pixel[3];
    sum[3] += pixel[3];
  }
  if (rows_ % factor_ == 0 || rows_ == height_) close_row();
}

/// Squares at the right and lower rim may be cut off: their means are of what there is.
void PictureRows::close_row() {
  const int rows = (rows_ - 1) % factor_ + 1;
  for (int x = 0; x < picture_.width; ++x) {
    const std::uint64_t* const sum = &sums_[static_cast<std::size_t>(x) * 4];
    const auto count = static_cast<std::uint64_t>(rows * std::min(factor_, width_ - x * factor_));
    for (int c = 0; c < 3; ++c) {
      picture_.rgba.push_back(sum[3] == 0 ? std::uint8_t{0}
                                          : static_cast<std::uint8_t>((sum[c] + sum[3] / 2) / sum[3]));
    }
    // Whole numbers with half added: rounded to the nearest, alike on every machine.
    picture_.rgba.push_back(static_cast<std::uint8_t>((sum[3] + count / 2) / count));
  }
  std::fill(sums_.begin(), sums_.end(), 0);
}

Picture PictureRows::take() {
  picture_.opaque = true;
  for (std::size_t i = 3; i < picture_.rgba.size(); i += 4) picture_.opaque &= picture_.rgba[i] == 255;
  return std::move(picture_);
}

}  // namespace toile::image
