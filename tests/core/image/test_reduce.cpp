#include "core/image/reduce.h"

#include <gtest/gtest.h>

#include "core/image/read_picture.h"
#include "core/image/write_png.h"

namespace toile::image {
namespace {

Picture plain(int width, int height, std::uint8_t red, std::uint8_t opacity = 255) {
  Picture p{width, height, {}, opacity == 255};
  for (int i = 0; i < width * height; ++i) p.rgba.insert(p.rgba.end(), {red, 10, 20, opacity});
  return p;
}

TEST(ReducedPicture, KeepsItsShapeAndAPlainColour) {
  const Picture small = reduced(plain(100, 37, 200), 30);
  EXPECT_EQ(small.width, 30);
  EXPECT_EQ(small.height, 11);
  EXPECT_EQ(small, plain(30, 11, 200));
}

TEST(ReducedPicture, IsTheMeanOfWhatEachPixelCoversInWholeAndInPart) {
  Picture three = plain(3, 1, 0);
  three.rgba[4] = 90;   // the middle pixel falls half to the left, half to the right
  three.rgba[8] = 210;  // right
  const Picture two = reduced(three, 2);
  EXPECT_EQ(two.rgba[0], 30);   // (0 + 90 / 2) / 1.5
  EXPECT_EQ(two.rgba[4], 170);  // (90 / 2 + 210) / 1.5
}

TEST(ReducedPicture, IsNotTintedByWhatIsHidden) {
  Picture two = plain(2, 1, 200);
  two.opaque = false;
  two.rgba[0] = 0;
  two.rgba[3] = 0;
  const Picture one = reduced(two, 1);
  EXPECT_EQ(one.rgba[0], 200);
  EXPECT_EQ(one.rgba[3], 128);
}

TEST(ReducedPicture, IsNeverMadeLarger) { EXPECT_EQ(reduced(plain(5, 4, 7), 9), plain(5, 4, 7)); }

TEST(ReducedPicture, GoesFromFileToFile) {
  const Picture large = plain(64, 80, 120, 100);
  const Result<std::string> file = encode_png(64, 80, 4, large.rgba);
  ASSERT_TRUE(file);
  const Result<std::string> small = reduced_png(*file, 16);
  ASSERT_TRUE(small);
  const Result<ReadPicture> read = read_picture(*small);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->picture, plain(16, 20, 120, 100));
  EXPECT_EQ(reduced_png("no picture", 16).error().code, "image.format");
}

}  // namespace
}  // namespace toile::image
