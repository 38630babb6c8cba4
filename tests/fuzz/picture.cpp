// PNG and JPEG files.

#include "core/image/read_picture.h"
#include "tests/core/image/jpegs.h"
#include "tests/core/image/pictures.h"
#include "tests/fuzz/fuzz.h"

namespace toile::fuzz {

std::vector<std::string> seeds() {
  const image::Picture small = test::squares(8);
  return {test::png_of(small),
          test::jpeg_of(small),
          test::jpeg_of(small, {.progressive = true}),
          test::jpeg_of(small, {.grey = true}),
          test::jpeg_of(small, {.inks = true}),
          test::jpeg_of(small, {.orientation = 6})};
}

void try_input(std::string_view bytes) {
  image::PictureLimits limits;  // small, so that a try takes milliseconds
  limits.side = 512;
  limits.pixels = limits.whole_pixels = 1 << 16;
  limits.shown_side = 64;
  limits.scans = 10;
  const Result<image::ReadPicture> read = image::read_picture(bytes, limits);
  if (!read) return;
  const image::Picture& shown = read->picture;
  expect(shown.width >= 1 && shown.height >= 1 && shown.width <= 64 && shown.height <= 64,
         "a picture is as small as asked");
  expect(shown.rgba.size() == std::size_t(4) * std::size_t(shown.width) * std::size_t(shown.height),
         "four numbers a pixel");
}

}  // namespace toile::fuzz
