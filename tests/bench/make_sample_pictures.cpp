// make_sample_pictures RESULTS SAMPLES SHEET.jpg NAME…
// From RESULTS/NAME/front.png, as `toile drape` leaves it: SAMPLES/NAME/picture.jpg, 360 pixels wide, and the
// contact sheet of all that are there. scripts/samples.sh calls it.
//
// make_sample_pictures --row RESULTS ROW.jpg NAME…
// These side by side in one row, smaller; what is not there stays empty. scripts/fabrics.sh calls it.

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

struct Size {
  int width = 0, height = 0;
};
constexpr Size kCard{360, 450};   // a picture on the page's cards
constexpr Size kSmall{240, 300};  // one of a row
constexpr int kColumns = 3, kQuality = 88;

std::string slurp(const fs::path& p) {
  std::ifstream in(p, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Each pixel the mean of those that it covers. REQUIRES whole multiples.
image::Picture reduced(const image::Picture& from, Size size) {
  image::Picture out{size.width, size.height,
                     std::vector<std::uint8_t>(std::size_t(size.width) * size.height * 4), true};
  const int step = from.width / size.width;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        int sum = 0;
        for (int k = 0; k < step * step; ++k)
          sum += from.rgba[(std::size_t(y * step + k / step) * from.width + x * step + k % step) * 4 + c];
        out.rgba[(std::size_t(y) * size.width + x) * 4 + c] = static_cast<std::uint8_t>(sum / (step * step));
      }
    }
  }
  return out;
}

/// The front still of a drape, so large.
Result<image::Picture> still_of(const fs::path& results, Size size) {
  const fs::path still = results / "front.png";
  const image::ReadPicture read = TRY(image::read_picture(slurp(still)));
  if (read.picture.width % size.width != 0 ||
      read.picture.height != read.picture.width / size.width * size.height)
    return Error{
        "usage.size",
        "stills must be a multiple of " + std::to_string(size.width) + "x" + std::to_string(size.height),
        still.string()};
  return reduced(read.picture, size);
}

image::Picture empty_sheet(Size size, int columns, int rows) {
  image::Picture sheet{size.width * columns, size.height * rows, {}, true};
  sheet.rgba.assign(std::size_t(sheet.width) * sheet.height * 4, 235);
  return sheet;
}

void put(const image::Picture& one, int column, int row, image::Picture& sheet) {
  const std::size_t line = std::size_t(one.width) * 4;
  for (int y = 0; y < one.height; ++y) {
    const auto* from = one.rgba.data() + static_cast<std::size_t>(y) * line;
    auto* to = sheet.rgba.data() +
               (std::size_t(row * one.height + y) * sheet.width + std::size_t(column) * one.width) * 4;
    std::copy_n(from, line, to);
  }
}

Status make_sheet(const fs::path& results, const fs::path& samples, const fs::path& file,
                  const std::vector<std::string>& names) {
  std::vector<image::Picture> all;
  for (const std::string& name : names) {
    if (!fs::exists(results / name / "front.png")) continue;
    all.push_back(TRY(still_of(results / name, kCard)));
    TRY(write_file(samples / name / "picture.jpg", test::jpeg_of(all.back(), {.quality = kQuality})));
  }
  const int rows = (static_cast<int>(all.size()) + kColumns - 1) / kColumns;
  image::Picture sheet = empty_sheet(kCard, kColumns, rows);
  for (int i = 0; i < static_cast<int>(all.size()); ++i) put(all[i], i % kColumns, i / kColumns, sheet);
  return write_file(file, test::jpeg_of(sheet, {.quality = kQuality}));
}

Status make_row(const fs::path& results, const fs::path& file, const std::vector<std::string>& names) {
  image::Picture row = empty_sheet(kSmall, static_cast<int>(names.size()), 1);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!fs::exists(results / names[i] / "front.png")) continue;
    put(TRY(still_of(results / names[i], kSmall)), static_cast<int>(i), 0, row);
  }
  return write_file(file, test::jpeg_of(row, {.quality = kQuality}));
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) {
    std::fprintf(stderr,
                 "make_sample_pictures RESULTS SAMPLES SHEET.jpg NAME…\n"
                 "make_sample_pictures --row RESULTS ROW.jpg NAME…\n");
    return 2;
  }
  const std::vector<std::string> names{arguments + 4, arguments + count};
  const bool row = arguments[1] == std::string("--row");
  const Status made = row ? make_row(arguments[2], arguments[3], names)
                          : make_sheet(arguments[1], arguments[2], arguments[3], names);
  if (made) return 0;
  std::fprintf(stderr, "%s\n", to_string(made.error()).c_str());
  return 1;
}
