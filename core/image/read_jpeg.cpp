#include "core/image/read_jpeg.h"

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Takes FILE and size_t for given.
#include <jpeglib.h>
// Takes jpeglib.h for given.
#include <jerror.h>

#include "core/image/exif.h"
#include "core/image/picture_rows.h"

namespace toile::image {
namespace {

/// One reading. libjpeg reports errors by a jump: nothing with a destructor may live in functions that it can
/// jump out of, so all of that lies here.
struct JpegReading {
  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg_progress_mgr progress = {};
  jmp_buf way_out = {};
  const PictureLimits& limits;
  bool ended_early = false;
  bool broken = false;  // entropy-coded data stops before its picture is full
  std::string words = {};
  std::optional<Error> refused = {};
  std::optional<PictureRows> rows = {};
  std::vector<JSAMPLE> decoded = {};
  std::vector<std::uint8_t> rgba = {};
  int orientation = 1;
  bool printed = false;  // CMYK
};

JpegReading& reading_of(j_common_ptr jpeg) { return *static_cast<JpegReading*>(jpeg->client_data); }

[[noreturn]] void on_error(j_common_ptr jpeg) {
  JpegReading& reading = reading_of(jpeg);
  char words[JMSG_LENGTH_MAX] = "";
  jpeg->err->format_message(jpeg, words);
  reading.words = words;
  reading.ended_early |= jpeg->err->msg_code == JERR_INPUT_EOF;
  std::longjmp(reading.way_out, 1);
}

/// libjpeg paints what is missing grey and goes on; here that is an error. Stray bytes between segments,
/// which cameras leave, are none.
void on_message(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  JpegReading& reading = reading_of(jpeg);
  ++jpeg->err->num_warnings;
  reading.ended_early |= jpeg->err->msg_code == JWRN_JPEG_EOF;
  reading.broken |= jpeg->err->msg_code == JWRN_HIT_MARKER || jpeg->err->msg_code == JWRN_HUFF_BAD_CODE ||
                    jpeg->err->msg_code == JWRN_MUST_RESYNC;
  if (reading.ended_early || reading.broken) {
    char words[JMSG_LENGTH_MAX] = "";
    jpeg->err->format_message(jpeg, words);
    reading.words = words;
    std::longjmp(reading.way_out, 1);
  }
}

void on_output(j_common_ptr) {}

void watch_scans(j_common_ptr jpeg) {
  JpegReading& reading = reading_of(jpeg);
  if (reading.jpeg.input_scan_number <= reading.limits.scans) return;
  reading.refused =
      Error{"image.too_large", "the JPEG file has too many scans; save it anew", "", ErrorKind::kTooLarge};
  std::longjmp(reading.way_out, 1);
}

/// After the header: sizes are known, nothing of theirs is taken yet. False when the picture is refused.
bool make_room(JpegReading& reading) {
  jpeg_decompress_struct& jpeg = reading.jpeg;
  const bool whole = jpeg_has_multiple_scans(&jpeg);
  if (Status fits = check_size(jpeg.image_width, jpeg.image_height, whole, reading.limits); !fits) {
    reading.refused = fits.error();
    return false;
  }
  for (const jpeg_marker_struct* marker = jpeg.marker_list; marker != nullptr; marker = marker->next) {
    if (reading.orientation == 1) reading.orientation = exif_orientation({marker->data, marker->data_length});
  }
  reading.printed = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  jpeg.out_color_space = reading.printed ? JCS_CMYK : JCS_RGB;
  jpeg.dct_method = JDCT_ISLOW;  // whole numbers: the same pixels on every machine
  const std::size_t width = jpeg.image_width;
  reading.rows.emplace(static_cast<int>(width), static_cast<int>(jpeg.image_height),
                       reading.limits.shown_side);
  reading.decoded.resize(width * (reading.printed ? 4 : 3));
  reading.rgba.resize(width * 4, 0xFF);
  return true;
}

/// Inks of a file that Adobe's programs wrote stand upside down: 255 is none.
void add_row(JpegReading& reading) {
  const JSAMPLE* from = reading.decoded.data();
  const bool inverted = reading.jpeg.saw_Adobe_marker;
  for (std::size_t x = 0; x < reading.rgba.size(); x += 4, from += reading.printed ? 4 : 3) {
    for (int c = 0; c < 3; ++c) {
      if (!reading.printed) {
        reading.rgba[x + c] = from[c];
        continue;
      }
      const int bare = inverted ? from[c] : 255 - from[c], light = inverted ? from[3] : 255 - from[3];
      reading.rgba[x + c] = static_cast<std::uint8_t>((bare * light + 127) / 255);
    }
  }
  reading.rows->add(reading.rgba);
}

bool decode(JpegReading& reading, std::string_view bytes) {
  jpeg_decompress_struct& jpeg = reading.jpeg;
  if (setjmp(reading.way_out)) return false;
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()),
               static_cast<unsigned long>(bytes.size()));
  jpeg_save_markers(&jpeg, JPEG_APP0 + 1, 0xFFFF);
  jpeg_read_header(&jpeg, TRUE);
  if (!make_room(reading)) return false;
  jpeg.progress = &reading.progress;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = reading.decoded.data();
    if (jpeg_read_scanlines(&jpeg, &row, 1) == 1) add_row(reading);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

Error fault_of(const JpegReading& reading) {
  if (reading.refused) return *reading.refused;
  if (reading.ended_early) return {"image.truncated", "the picture's file ends early; send all of it", ""};
  return {"image.damaged", "the picture cannot be read: " + reading.words, ""};
}

}  // namespace

Result<ReadPicture> read_jpeg(std::string_view bytes, const PictureLimits& limits) {
  JpegReading reading{.limits = limits};
  reading.jpeg.err = jpeg_std_error(&reading.errors);
  reading.jpeg.client_data = &reading;
  reading.errors.error_exit = on_error;
  reading.errors.emit_message = on_message;
  reading.errors.output_message = on_output;
  reading.progress.progress_monitor = watch_scans;
  const bool done = decode(reading, bytes);
  const int width = static_cast<int>(reading.jpeg.image_width);
  const int height = static_cast<int>(reading.jpeg.image_height);
  jpeg_destroy_decompress(&reading.jpeg);
  if (!done) return fault_of(reading);
  const bool swapped = reading.orientation >= 5;
  ReadPicture out{PictureFormat::kJpeg, swapped ? height : width, swapped ? width : height, {}, true};
  out.plain = !reading.rows->reduced() && !reading.printed && reading.orientation == 1;
  out.picture = turned(reading.rows->take(), reading.orientation);
  return out;
}

}  // namespace toile::image
