#include "server/render/png.h"

#include <png.h>

#include <csetjmp>

#include "core/base/write_file.h"

namespace toile {
namespace {

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

void flush(png_structp) {}

/// libpng reports errors by a jump back to here; no object with a destructor may be made after it.
bool encode(png_structp png, png_infop info, const Image& image, std::string& bytes) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &bytes, append, flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, 6);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(png, image.rgb.data() + static_cast<std::size_t>(y) * image.width * 3);
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

Result<std::string> png_bytes(const Image& image) {
  if (image.width <= 0 || image.height <= 0 ||
      image.rgb.size() !=
          static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3) {
    return Error{"render.bad_image", "the image's bytes do not fit its width and height", ""};
  }
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  const bool done = info != nullptr && encode(png, info, image, bytes);
  png_destroy_write_struct(&png, &info);
  if (!done) return Error{"render.bad_image", "the image could not be encoded as PNG", ""};
  return bytes;
}

Status write_png(const std::filesystem::path& path, const Image& image) {
  const Result<std::string> bytes = png_bytes(image);
  if (!bytes.ok()) return bytes.error();
  return write_file(path, *bytes);
}

}  // namespace toile
