#include "tests/core/image/jpegs.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

// Takes FILE and size_t for given.
#include <jpeglib.h>

namespace toile::test {
namespace {

/// "Exif", a TIFF block of big-endian numbers, and in it one entry.
std::vector<unsigned char> exif(int orientation) {
  std::vector<unsigned char> out{'E', 'x', 'i', 'f', 0, 0, 'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1};
  const unsigned char entry[] = {0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, static_cast<unsigned char>(orientation),
                                 0,    0,    0, 0, 0, 0};
  out.insert(out.end(), std::begin(entry), std::end(entry));
  return out;
}

std::vector<JSAMPLE> row_of(const image::Picture& picture, int y, const JpegWishes& wishes) {
  std::vector<JSAMPLE> row;
  for (int x = 0; x < picture.width; ++x) {
    const std::uint8_t* const p = &picture.rgba[(static_cast<std::size_t>(y) * picture.width + x) * 4];
    if (wishes.grey) {
      row.push_back(p[1]);
    } else if (wishes.inks) {
      // All that a colour lacks of its lightest channel; Adobe's inks: 255 is none.
      const int light = std::max({p[0], p[1], p[2], std::uint8_t{1}});
      for (int c = 0; c < 3; ++c) row.push_back(static_cast<JSAMPLE>(p[c] * 255 / light));
      row.push_back(static_cast<JSAMPLE>(light));
    } else {
      row.insert(row.end(), p, p + 3);
    }
  }
  return row;
}

}  // namespace

std::string jpeg_of(const image::Picture& picture, const JpegWishes& wishes) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(picture.width);
  jpeg.image_height = static_cast<JDIMENSION>(picture.height);
  jpeg.input_components = wishes.grey ? 1 : wishes.inks ? 4 : 3;
  jpeg.in_color_space = wishes.grey ? JCS_GRAYSCALE : wishes.inks ? JCS_CMYK : JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, wishes.quality, TRUE);
  for (int c = 0; c < jpeg.num_components; ++c)
    jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
  if (wishes.inks) jpeg.write_Adobe_marker = TRUE;
  if (wishes.progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  if (wishes.orientation != 0) {
    const std::vector<unsigned char> segment = exif(wishes.orientation);
    jpeg_write_marker(&jpeg, JPEG_APP0 + 1, segment.data(), static_cast<unsigned>(segment.size()));
  }
  for (int y = 0; y < picture.height; ++y) {
    std::vector<JSAMPLE> row = row_of(picture, y, wishes);
    JSAMPROW start = row.data();
    jpeg_write_scanlines(&jpeg, &start, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string out(reinterpret_cast<const char*>(bytes), size);
  std::free(bytes);
  return out;
}

}  // namespace toile::test
