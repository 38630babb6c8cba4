#include "core/mesh/seam_intervals.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

using Breaks = std::vector<double>;

TEST(SeamIntervals, TwoPlainSidesAreOneInterval) {
  const auto intervals = mesh::seam_intervals(Breaks{0, 0.3}, Breaks{0, 0.31}, 0.01);
  ASSERT_EQ(intervals.size(), 1u);
  EXPECT_EQ(intervals[0].segments, 31);
  EXPECT_EQ(intervals[0].a1, 0.3);
  EXPECT_EQ(intervals[0].b1, 0.31);
}

TEST(SeamIntervals, ACornerCutsTheOtherSideInProportion) {
  const auto intervals = mesh::seam_intervals(Breaks{0, 0.1, 0.3}, Breaks{0, 0.6}, 0.01);
  ASSERT_EQ(intervals.size(), 2u);
  EXPECT_EQ(intervals[0].a1, 0.1);
  EXPECT_NEAR(intervals[0].b1, 0.2, 1e-15);
  EXPECT_EQ(intervals[0].segments, 20);
  EXPECT_EQ(intervals[1].segments, 40);
}

TEST(SeamIntervals, CornersThatNearlyFaceEachOtherMeet) {
  // 0.5 against 0.502 of 0.6 m: 1.2 mm apart, under 0.35 of 10 mm.
  const auto intervals = mesh::seam_intervals(Breaks{0, 0.3, 0.6}, Breaks{0, 0.251, 0.5}, 0.01);
  ASSERT_EQ(intervals.size(), 2u);
  EXPECT_EQ(intervals[0].a1, 0.3);
  EXPECT_EQ(intervals[0].b1, 0.251);
}

TEST(SeamIntervals, CornersFartherApartStayApart) {
  const auto intervals = mesh::seam_intervals(Breaks{0, 0.3, 0.6}, Breaks{0, 0.304, 0.6}, 0.01);
  ASSERT_EQ(intervals.size(), 3u);
  EXPECT_EQ(intervals[1].segments, 1);
}

TEST(SeamIntervals, ACornerMeetsTheNearestOfSeveral) {
  const auto intervals = mesh::seam_intervals(Breaks{0, 0.3, 0.6}, Breaks{0, 0.2975, 0.301, 0.6}, 0.01);
  ASSERT_EQ(intervals.size(), 3u);
  EXPECT_EQ(intervals[0].b1, 0.2975);
  EXPECT_EQ(intervals[1].b1, 0.301);
  EXPECT_EQ(intervals[1].a1, 0.3);
  EXPECT_LT(intervals[0].a1, 0.3);
}

TEST(SeamIntervals, CutsRiseOnBothSidesWhateverTheCorners) {
  for (int shift = -20; shift <= 20; ++shift) {
    const double d = shift * 0.0003;
    const auto intervals = mesh::seam_intervals(Breaks{0, 0.1, 0.104, 0.2, 0.29, 0.4},
                                                Breaks{0, 0.1 + d, 0.103 + d, 0.201, 0.292 - d, 0.45}, 0.01);
    for (const mesh::SeamInterval& i : intervals) {
      EXPECT_LT(i.a0, i.a1);
      EXPECT_LT(i.b0, i.b1);
      EXPECT_GE(i.segments, 1);
    }
  }
}

TEST(SegmentCount, IsTheNearestWholeNumberAndAtLeastOne) {
  EXPECT_EQ(mesh::segment_count(0.149, 0.01), 15);
  EXPECT_EQ(mesh::segment_count(0.001, 0.01), 1);
}

}  // namespace
}  // namespace toile
