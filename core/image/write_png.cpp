#include "core/image/write_png.h"

#include <png.h>
#include <zlib.h>

#include <csetjmp>
#include <cstddef>

namespace toile::image {
namespace {

struct Pixels {
  int width, height, channels;
  const std::uint8_t* data;
  PngMatches matches;
};

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

void flush(png_structp) {}

/// libpng reports errors by a jump back to here; no object with a destructor may be made after it.
bool encode(png_structp png, png_infop info, const Pixels& from, std::string& bytes) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &bytes, append, flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(from.width), static_cast<png_uint_32>(from.height), 8,
               from.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // Says what the colours are, or some programs show them too dark.
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  // Named, so that libpng's default may change and the bytes do not.
  png_set_compression_level(png, 6);
  if (from.matches == PngMatches::kRuns) png_set_compression_strategy(png, Z_RLE);
  png_write_info(png, info);
  for (int y = 0; y < from.height; ++y) {
    png_write_row(png, from.data + static_cast<std::size_t>(y) * from.width * from.channels);
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

Result<std::string> encode_png(int width, int height, int channels, std::span<const std::uint8_t> pixels,
                               PngMatches matches) {
  const bool fits = width > 0 && height > 0 && (channels == 3 || channels == 4) &&
                    pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                         static_cast<std::size_t>(channels);
  if (!fits) return Error{"image.bad_size", "the image's bytes do not fit its width and height", ""};
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  const bool done =
      info != nullptr && encode(png, info, {width, height, channels, pixels.data(), matches}, bytes);
  png_destroy_write_struct(&png, &info);
  if (!done) return Error{"image.bad_size", "the image could not be encoded as PNG", ""};
  return bytes;
}

}  // namespace toile::image
