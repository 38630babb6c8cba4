#include "core/image/read_picture.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>

#include "core/image/exif.h"
#include "tests/core/image/jpegs.h"
#include "tests/core/image/pictures.h"

namespace toile {
namespace {

using test::jpeg_of;
using test::painted;
using test::png_of;
using test::squares;

using Colour = std::array<int, 4>;

Colour at(const image::Picture& picture, int x, int y) {
  const std::size_t i = (static_cast<std::size_t>(y) * picture.width + x) * 4;
  return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2], picture.rgba[i + 3]};
}

testing::AssertionResult is_about(Colour seen, Colour wanted, int most = 6) {
  for (int c = 0; c < 4; ++c) {
    if (std::abs(seen[c] - wanted[c]) > most)
      return testing::AssertionFailure()
             << seen[0] << " " << seen[1] << " " << seen[2] << " " << seen[3] << " is not " << wanted[0]
             << " " << wanted[1] << " " << wanted[2] << " " << wanted[3];
  }
  return testing::AssertionSuccess();
}

const Colour kRed{200, 30, 20, 255}, kBlue{20, 40, 200, 255}, kWhite{250, 250, 250, 255};

/// libpng's simple writer: other kinds of PNG than our own.
std::string png_of_kind(int width, int height, png_uint_32 format, const void* pixels, const void* colours,
                        png_uint_32 colour_count) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  image.colormap_entries = colour_count;
  png_alloc_size_t size = 0;
  EXPECT_NE(png_image_write_to_memory(&image, nullptr, &size, 0, pixels, 0, colours), 0);
  std::string bytes(size, '\0');
  EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, colours), 0);
  bytes.resize(size);
  return bytes;
}

std::string interlaced_png(const image::Picture& picture) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, png_size_t size) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), size);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
               8, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  std::vector<png_bytep> rows;
  for (int y = 0; y < picture.height; ++y)
    rows.push_back(const_cast<png_bytep>(&picture.rgba[static_cast<std::size_t>(y) * picture.width * 4]));
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

TEST(ReadPicture, GivesBackThePixelsOfAPng) {
  const Result<image::ReadPicture> read = image::read_picture(png_of(squares()));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->format, image::PictureFormat::kPng);
  EXPECT_EQ(read->width, 16);
  EXPECT_EQ(read->height, 16);
  EXPECT_TRUE(read->plain);
  EXPECT_EQ(read->picture, squares());
}

TEST(ReadPicture, KeepsTheOpacityOfAPng) {
  const image::Picture glass = painted(3, 2, [](int x, int y) -> Colour {
    return {10, 20, 30, 40 * (x + 3 * y)};
  });
  const Result<image::ReadPicture> read = image::read_picture(png_of(glass));
  ASSERT_TRUE(read.ok());
  EXPECT_FALSE(read->picture.opaque);
  EXPECT_EQ(read->picture, glass);
}

TEST(ReadPicture, ReadsPalettesGreysAndSixteenBits) {
  const std::array<png_byte, 6> colours{200, 30, 20, 20, 40, 200};
  const std::array<png_byte, 4> places{0, 1, 1, 0};
  const auto palette =
      image::read_picture(png_of_kind(2, 2, PNG_FORMAT_RGB_COLORMAP, places.data(), colours.data(), 2));
  ASSERT_TRUE(palette.ok()) << to_string(palette.error());
  EXPECT_EQ(at(palette->picture, 1, 0), kBlue);
  EXPECT_EQ(at(palette->picture, 1, 1), kRed);

  const std::array<png_byte, 2> greys{0, 77};
  const auto grey = image::read_picture(png_of_kind(2, 1, PNG_FORMAT_GRAY, greys.data(), nullptr, 0));
  ASSERT_TRUE(grey.ok());
  EXPECT_EQ(at(grey->picture, 1, 0), (Colour{77, 77, 77, 255}));
  EXPECT_TRUE(grey->plain);

  const std::array<png_uint_16, 3> deep{65535, 0, 65535};
  const auto sixteen = image::read_picture(png_of_kind(1, 1, PNG_FORMAT_LINEAR_RGB, deep.data(), nullptr, 0));
  ASSERT_TRUE(sixteen.ok());
  EXPECT_EQ(at(sixteen->picture, 0, 0), (Colour{255, 0, 255, 255}));
  EXPECT_FALSE(sixteen->plain);
}

TEST(ReadPicture, ReadsAnInterlacedPng) {
  const auto read = image::read_picture(interlaced_png(squares(13)));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->picture, squares(13));
}

TEST(ReadPicture, ReadsJpegsOfAllUsualKinds) {
  for (const test::JpegWishes& wishes :
       {test::JpegWishes{}, {.progressive = true}, {.inks = true}, {.quality = 100}}) {
    const auto read = image::read_picture(jpeg_of(squares(32), wishes));
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->format, image::PictureFormat::kJpeg);
    EXPECT_TRUE(is_about(at(read->picture, 3, 3), kRed));
    EXPECT_TRUE(is_about(at(read->picture, 28, 3), kWhite));
    EXPECT_TRUE(is_about(at(read->picture, 28, 28), kBlue));
    EXPECT_EQ(read->plain, !wishes.inks);
  }
  const auto grey = image::read_picture(jpeg_of(squares(32), {.grey = true}));
  ASSERT_TRUE(grey.ok());
  EXPECT_TRUE(is_about(at(grey->picture, 3, 3), {30, 30, 30, 255}));
}

TEST(ReadPicture, TurnsAPhotographAsItWasHeld) {
  // Wider than high, red at its upper left corner alone.
  const image::Picture flag = painted(48, 32, [](int x, int y) { return x < 16 && y < 16 ? kRed : kWhite; });
  struct Case {
    int orientation, width, x, y;  // where the red corner is seen
  };
  for (const Case& c : {Case{1, 48, 3, 3},
                        {2, 48, 44, 3},
                        {3, 48, 44, 28},
                        {4, 48, 3, 28},
                        {5, 32, 3, 3},
                        {6, 32, 28, 3},
                        {7, 32, 28, 44},
                        {8, 32, 3, 44}}) {
    const auto read = image::read_picture(jpeg_of(flag, {.orientation = c.orientation}));
    ASSERT_TRUE(read.ok()) << c.orientation;
    EXPECT_EQ(read->width, c.width) << c.orientation;
    EXPECT_EQ(read->picture.width, c.width) << c.orientation;
    EXPECT_EQ(read->picture.height, 80 - c.width) << c.orientation;
    EXPECT_TRUE(is_about(at(read->picture, c.x, c.y), kRed)) << c.orientation;
    EXPECT_TRUE(is_about(at(read->picture, c.width - 1 - c.x, c.y), kWhite)) << c.orientation;
    EXPECT_EQ(read->plain, c.orientation == 1) << c.orientation;
  }
}

TEST(ReadPicture, TellsTheKindByTheBytesAndNotByTheName) {
  EXPECT_EQ(image::read_picture("").error().code, "image.format");
  EXPECT_EQ(image::read_picture("GIF89a............").error().code, "image.format");
  EXPECT_NE(image::read_picture("GIF89a............").error().message.find("GIF"), std::string::npos);
  EXPECT_NE(image::read_picture("RIFF....WEBPVP8 ").error().message.find("WebP"), std::string::npos);
  EXPECT_EQ(image::read_picture("<svg onload='x'/>").error().code, "image.format");
  EXPECT_EQ(image::picture_format(jpeg_of(squares())), image::PictureFormat::kJpeg);
  EXPECT_EQ(image::picture_format("\x89PNG"), std::nullopt);
}

TEST(ReadPicture, ReducesALargePictureByMeansOfItsPixels) {
  const image::Picture fine = painted(103, 50, [](int x, int y) {
    return (x + y) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
  });
  const auto read = image::read_picture(png_of(fine), {.shown_side = 60});
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->width, 103);
  EXPECT_EQ(read->height, 50);
  EXPECT_EQ(read->picture.width, 52);
  EXPECT_EQ(read->picture.height, 25);
  EXPECT_FALSE(read->plain);
  for (int y = 0; y < 25; ++y) {
    for (int x = 0; x < 52; ++x) EXPECT_TRUE(is_about(at(read->picture, x, y), {128, 128, 128, 255}, 1));
  }
}

TEST(ReadPicture, DoesNotMixTheColourOfWhatCannotBeSeen) {
  const image::Picture half = painted(2, 2, [](int x, int) { return x == 0 ? kRed : Colour{0, 255, 0, 0}; });
  const auto read = image::read_picture(png_of(half), {.shown_side = 1});
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(at(read->picture, 0, 0), (Colour{200, 30, 20, 128}));
}

/// The size in the header of a PNG, with the checksum that belongs to it.
std::string with_size(std::string png, std::uint32_t width, std::uint32_t height) {
  const auto put = [&](std::size_t place, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) png[place + i] = static_cast<char>(value >> (24 - 8 * i) & 0xFF);
  };
  put(16, width);
  put(20, height);
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<unsigned char>(png[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xEDB88320u : 0);
  }
  put(29, ~crc);
  return png;
}

TEST(ReadPicture, RefusesABombByItsHeader) {
  const std::string small = png_of(squares());
  EXPECT_TRUE(image::read_picture(with_size(small, 16, 16)).ok());
  EXPECT_EQ(image::read_picture(with_size(small, 16384, 16384)).error().code, "image.too_large");
  EXPECT_EQ(image::read_picture(with_size(small, 1u << 30, 1)).ok(), false);
  EXPECT_EQ(image::read_picture(with_size(interlaced_png(squares()), 8192, 8192)).error().code,
            "image.too_large");
  EXPECT_EQ(image::read_picture(small, {.bytes = 50}).error().code, "image.too_large");
  EXPECT_EQ(image::read_picture(jpeg_of(squares()), {.side = 15}).error().code, "image.too_large");
  EXPECT_EQ(
      image::read_picture(jpeg_of(squares(), {.progressive = true}), {.whole_pixels = 255}).error().code,
      "image.too_large");
  EXPECT_EQ(image::read_picture(jpeg_of(squares(), {.progressive = true}), {.scans = 2}).error().code,
            "image.too_large");
}

TEST(ReadPicture, SaysThatAFileEndsEarly) {
  const image::Picture rough = painted(64, 64, [](int x, int y) -> Colour {
    return {(x * 37 + y * 91) % 256, (x * y) % 256, (x * 7) % 256, 255};
  });
  const std::string png = png_of(rough), jpeg = jpeg_of(rough), late = jpeg_of(rough, {.progressive = true});
  for (const double share : {0.3, 0.7, 0.95}) {
    for (const std::string* file : {&png, &jpeg, &late}) {
      const auto read = image::read_picture(
          file->substr(0, static_cast<std::size_t>(share * static_cast<double>(file->size()))));
      ASSERT_FALSE(read.ok()) << share;
      EXPECT_EQ(read.error().code, "image.truncated") << share << " " << read.error().message;
    }
  }
}

TEST(ReadPicture, SaysThatAFileIsDamaged) {
  std::string png = png_of(squares());
  png[png.size() - 20] ^= 0x55;  // within the pixels: their checksum does not fit
  EXPECT_EQ(image::read_picture(png).error().code, "image.damaged");
  std::string jpeg = jpeg_of(squares());
  jpeg[jpeg.find("\xff\xc0") + 1] = '\xc3';  // a way of packing that hardly anybody reads
  const auto read = image::read_picture(jpeg);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, "image.damaged");
}

TEST(ReadPicture, ComesThroughAThousandDamagedFiles) {
  std::mt19937 random(11);
  const std::array<std::string, 4> files{png_of(squares(24)), interlaced_png(squares(24)),
                                         jpeg_of(squares(24)),
                                         jpeg_of(squares(24), {.progressive = true, .orientation = 6})};
  int refused = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string file = files[trial % 4];
    for (int i = 0; i < 1 + trial % 7; ++i) file[random() % file.size()] = static_cast<char>(random());
    if (trial % 5 == 0) file.resize(random() % file.size());
    const auto read = image::read_picture(file, {.pixels = 1 << 20, .whole_pixels = 1 << 18});
    if (!read.ok()) {
      ++refused;
      EXPECT_TRUE(read.error().code.starts_with("image.")) << read.error().code;
      EXPECT_FALSE(read.error().message.empty());
    } else {
      EXPECT_EQ(read->picture.rgba.size(),
                static_cast<std::size_t>(read->picture.width) * read->picture.height * 4);
    }
  }
  EXPECT_GT(refused, 400);
}

TEST(Exif, OfADamagedSegmentIsUpright) {
  std::vector<unsigned char> segment{'E',  'x',  'i', 'f', 0, 0, 'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0,
                                     0x12, 0x01, 3,   0,   1, 0, 0,   0,   6,  0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(image::exif_orientation(segment), 6);
  for (std::size_t size = 0; size < 26; ++size)
    EXPECT_EQ(image::exif_orientation({segment.data(), size}), 1) << size;
  segment[10] = 0xFF;  // the list of entries would begin far behind the end
  segment[13] = 0xFF;
  EXPECT_EQ(image::exif_orientation(segment), 1);
}

TEST(OverGround, LetsTheGroundShineThroughInLight) {
  const image::Picture half = painted(2, 1, [](int x, int) -> Colour {
    return {255, 255, 255, x == 0 ? 0 : 128};
  });
  const image::Picture seen = image::over_ground(half, {0, 1, 0});
  EXPECT_TRUE(seen.opaque);
  EXPECT_EQ(at(seen, 0, 0), (Colour{0, 255, 0, 255}));
  EXPECT_TRUE(is_about(at(seen, 1, 0), {188, 255, 188, 255}, 1));
  EXPECT_EQ(image::over_ground(squares(), {0, 0, 0}), squares());
}

}  // namespace
}  // namespace toile
