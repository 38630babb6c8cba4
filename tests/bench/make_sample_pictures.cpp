// make_sample_pictures RESULTS SAMPLES SHEET.jpg NAME…
// From RESULTS/NAME/front.png, as `toile drape` leaves it: SAMPLES/NAME/picture.jpg, 360 pixels wide, and the
// contact sheet of all that are there. scripts/samples.sh calls it.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/base/write_file.h"
#include "core/image/read_picture.h"
#include "tests/core/image/jpegs.h"

namespace {

namespace fs = std::filesystem;
using namespace toile;

constexpr int kWidth = 360, kHeight = 450;  // of a picture on the page's cards
constexpr int kColumns = 4, kQuality = 88;

std::string slurp(const fs::path& p) {
  std::ifstream in(p, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Each pixel the mean of those that it covers. REQUIRES whole multiples.
image::Picture reduced(const image::Picture& from) {
  image::Picture out{kWidth, kHeight, std::vector<std::uint8_t>(std::size_t(kWidth) * kHeight * 4), true};
  const int step = from.width / kWidth;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < 4; ++c) {
        int sum = 0;
        for (int k = 0; k < step * step; ++k)
          sum += from.rgba[(std::size_t(y * step + k / step) * from.width + x * step + k % step) * 4 + c];
        out.rgba[(std::size_t(y) * kWidth + x) * 4 + c] = static_cast<std::uint8_t>(sum / (step * step));
      }
    }
  }
  return out;
}

void put(const image::Picture& one, int column, int row, image::Picture& sheet) {
  for (int y = 0; y < kHeight; ++y) {
    const auto* from = one.rgba.data() + std::size_t(y) * kWidth * 4;
    auto* to = sheet.rgba.data() + (std::size_t(row * kHeight + y) * sheet.width + column * kWidth) * 4;
    std::copy_n(from, std::size_t(kWidth) * 4, to);
  }
}

Status make(const fs::path& results, const fs::path& samples, const fs::path& file,
            const std::vector<std::string>& names) {
  std::vector<image::Picture> all;
  for (const std::string& name : names) {
    const fs::path still = results / name / "front.png";
    if (!fs::exists(still)) continue;
    const image::ReadPicture read = TRY(image::read_picture(slurp(still)));
    if (read.picture.width % kWidth != 0 || read.picture.height != read.picture.width / kWidth * kHeight)
      return Error{"usage.size", "stills must be a multiple of 360x450", still.string()};
    all.push_back(reduced(read.picture));
    TRY(write_file(samples / name / "picture.jpg", test::jpeg_of(all.back(), {.quality = kQuality})));
  }
  const int rows = (static_cast<int>(all.size()) + kColumns - 1) / kColumns;
  image::Picture sheet{kWidth * kColumns, kHeight * rows, {}, true};
  sheet.rgba.assign(std::size_t(sheet.width) * sheet.height * 4, 235);
  for (int i = 0; i < static_cast<int>(all.size()); ++i) put(all[i], i % kColumns, i / kColumns, sheet);
  return write_file(file, test::jpeg_of(sheet, {.quality = kQuality}));
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) {
    std::fprintf(stderr, "make_sample_pictures RESULTS SAMPLES SHEET.jpg NAME…\n");
    return 2;
  }
  const Status made = make(arguments[1], arguments[2], arguments[3], {arguments + 4, arguments + count});
  if (made) return 0;
  std::fprintf(stderr, "%s\n", to_string(made.error()).c_str());
  return 1;
}
