#include "core/image/read_png.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/image/picture_rows.h"

namespace toile::image {
namespace {

constexpr png_uint_32 kMostChunks = 1000;              // of texts and the like
constexpr png_alloc_size_t kMostChunkBytes = 1 << 20;  // unpacked

/// One reading. libpng reports errors by a jump: nothing with a destructor may live in functions that it can
/// jump out of, so all of that lies here.
struct PngReading {
  std::string_view bytes;
  const PictureLimits& limits;
  std::size_t at = 0;
  bool ended_early = false;
  std::string words = {};
  std::optional<Error> refused = {};
  std::optional<PictureRows> rows = {};
  std::vector<png_byte> pixels = {};  // of a row, or of all when it is interlaced
  std::vector<png_bytep> row_starts = {};
  bool deep = false;
  int width = 0, height = 0;
};

PngReading& reading_of(png_structp png) { return *static_cast<PngReading*>(png_get_error_ptr(png)); }

void give_bytes(png_structp png, png_bytep out, png_size_t size) {
  PngReading& reading = reading_of(png);
  if (size > reading.bytes.size() - reading.at) {
    reading.ended_early = true;
    png_error(png, "the file ends early");
  }
  std::memcpy(out, reading.bytes.data() + reading.at, size);
  reading.at += size;
}

void on_error(png_structp png, png_const_charp words) {
  reading_of(png).words = words;
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

/// Every kind becomes four bytes a pixel. Gives back whether the file is interlaced.
bool ask_for_rgba(png_structp png, png_infop info) {
  const bool interlaced = png_set_interlace_handling(png) > 1;
  png_set_expand(png);  // palettes, fewer bits, and a colour that stands for nothing
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != std::size_t{4} * png_get_image_width(png, info)) {
    png_error(png, "its rows are of no known kind");
  }
  return interlaced;
}

/// After the header: sizes are known, nothing of theirs is taken yet. False when the picture is refused.
bool make_room(PngReading& reading, png_structp png, png_infop info) {
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  const bool interlaced = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
  if (Status fits = check_size(width, height, interlaced, reading.limits); !fits) {
    reading.refused = fits.error();
    return false;
  }
  reading.width = static_cast<int>(width);
  reading.height = static_cast<int>(height);
  reading.deep = png_get_bit_depth(png, info) > 8;
  reading.rows.emplace(reading.width, reading.height, reading.limits.shown_side);
  const std::size_t stride = std::size_t{4} * width;
  reading.pixels.resize(interlaced ? stride * height : stride);
  if (!interlaced) return true;
  // Interlaced pictures come in seven passes over all rows and need them all at once.
  for (png_uint_32 y = 0; y < height; ++y) reading.row_starts.push_back(reading.pixels.data() + stride * y);
  return true;
}

void add_rows(PngReading& reading) {
  for (const png_bytep row : reading.row_starts)
    reading.rows->add({row, static_cast<std::size_t>(reading.width) * 4});
}

bool decode(png_structp png, png_infop info, PngReading& reading) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_info(png, info);
  if (!make_room(reading, png, info)) return false;
  if (ask_for_rgba(png, info)) {
    png_read_image(png, reading.row_starts.data());
    add_rows(reading);
  } else {
    for (int y = 0; y < reading.height; ++y) {
      png_read_row(png, reading.pixels.data(), nullptr);
      reading.rows->add(reading.pixels);
    }
  }
  png_read_end(png, nullptr);
  return true;
}

void set_limits(png_structp png, const PictureLimits& limits) {
  const auto most = static_cast<png_uint_32>(limits.side);
  png_set_user_limits(png, most, most);
  png_set_chunk_cache_max(png, kMostChunks);
  png_set_chunk_malloc_max(png, kMostChunkBytes);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
}

Error fault_of(const PngReading& reading) {
  if (reading.refused) return *reading.refused;
  if (reading.ended_early) return {"image.truncated", "the picture's file ends early; send all of it", ""};
  return {"image.damaged", "the picture cannot be read: " + reading.words, ""};
}

}  // namespace

Result<ReadPicture> read_png(std::string_view bytes, const PictureLimits& limits) {
  PngReading reading{.bytes = bytes, .limits = limits};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, on_error, on_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr) {
    png_destroy_read_struct(&png, nullptr, nullptr);
    return Error{"image.damaged", "there is no memory for reading the picture", ""};
  }
  png_set_read_fn(png, &reading, give_bytes);
  set_limits(png, limits);
  const bool done = decode(png, info, reading);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!done) return fault_of(reading);
  ReadPicture out{PictureFormat::kPng, reading.width, reading.height, {}, true};
  out.plain = !reading.rows->reduced() && !reading.deep;
  out.picture = reading.rows->take();
  return out;
}

}  // namespace toile::image
