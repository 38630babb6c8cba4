#include "core/image/reduce.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/image/read_picture.h"
#include "core/image/write_png.h"

namespace toile::image {
namespace {

/// The pixels of a side that one pixel of the shorter side covers, and how much of each.
struct Covered {
  int first = 0;
  std::vector<double> share;
};

std::vector<Covered> covered_by(int from, int to) {
  std::vector<Covered> out(static_cast<std::size_t>(to));
  for (int i = 0; i < to; ++i) {
    const double low = static_cast<double>(i) * from / to, high = static_cast<double>(i + 1) * from / to;
    Covered& c = out[static_cast<std::size_t>(i)];
    c.first = static_cast<int>(low);
    for (int k = c.first; k < from && k < high; ++k)
      c.share.push_back(std::min(high, k + 1.0) - std::max(low, static_cast<double>(k)));
  }
  return out;
}

/// Red, green and blue by how opaque they are (what is hidden must not tint), opacity, all times area.
struct Sum {
  double rgb[3] = {0, 0, 0};
  double opacity = 0, area = 0;
};

void add_pixel(Sum& sum, const std::uint8_t* pixel, double area) {
  for (int c = 0; c < 3; ++c) sum.rgb[c] += area * pixel[3] * pixel[c];
  sum.opacity += area * pixel[3];
  sum.area += area;
}

Sum sum_over(const Picture& picture, const Covered& across, const Covered& down) {
  Sum sum;
  for (std::size_t y = 0; y < down.share.size(); ++y) {
    const std::size_t row = (static_cast<std::size_t>(down.first) + y) * picture.width + across.first;
    for (std::size_t x = 0; x < across.share.size(); ++x)
      add_pixel(sum, &picture.rgba[4 * (row + x)], across.share[x] * down.share[y]);
  }
  return sum;
}

std::uint8_t rounded(double value) { return static_cast<std::uint8_t>(std::lround(value)); }

}  // namespace

Picture reduced(const Picture& picture, int width) {
  if (picture.width <= width) return picture;
  Picture out;
  out.width = width;
  const double height = std::round(static_cast<double>(picture.height) * width / picture.width);
  out.height = std::max(1, static_cast<int>(height));
  out.opaque = picture.opaque;
  const std::vector<Covered> across = covered_by(picture.width, out.width);
  for (const Covered& down : covered_by(picture.height, out.height)) {
    for (const Covered& over : across) {
      const Sum sum = sum_over(picture, over, down);
      for (const double c : sum.rgb) out.rgba.push_back(sum.opacity > 0 ? rounded(c / sum.opacity) : 0);
      out.rgba.push_back(rounded(sum.opacity / sum.area));
    }
  }
  return out;
}

Result<std::string> reduced_png(std::string_view bytes, int width) {
  const ReadPicture read = TRY(read_picture(bytes));
  const Picture small = reduced(read.picture, width);
  if (!small.opaque) return encode_png(small.width, small.height, 4, small.rgba);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(small.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < small.rgba.size(); i += 4)
    rgb.insert(rgb.end(), {small.rgba[i], small.rgba[i + 1], small.rgba[i + 2]});
  return encode_png(small.width, small.height, 3, rgb);
}

}  // namespace toile::image
