// Figure 7 of Kim and Park 2003: paths against triangles, and candidates by height.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/paper/height_sorted.h"
#include "core/paper/path.h"
#include "core/paper/solids.h"

namespace toile {
namespace {

/// In the plane y = `y`, facing up.
paper::Corners floor_at(double y) { return {{{0, y, 0}, {0, y, 1}, {1, y, 0}}}; }

TEST(Path, StrikesATriangleThatItPassesThrough) {
  const auto hit = paper::path_hit_outside({0.2, 1, 0.2}, {0.2, -1, 0.2}, floor_at(0));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->at, 0.5, 1e-15);
  EXPECT_NEAR(hit->share[1], 0.2, 1e-15);
  EXPECT_NEAR(hit->share[2], 0.2, 1e-15);
}

TEST(Path, BesideATriangleShortOfItOrFromWithinStrikesNothing) {
  EXPECT_FALSE(paper::path_hit_outside({0.7, 1, 0.7}, {0.7, -1, 0.7}, floor_at(0)));
  EXPECT_FALSE(paper::path_hit_outside({0.2, 1, 0.2}, {0.2, 0.1, 0.2}, floor_at(0)));
  EXPECT_FALSE(paper::path_hit_outside({0.2, -1, 0.2}, {0.2, 1, 0.2}, floor_at(0)));
}

TEST(Path, ThroughTheEdgeThatTwoTrianglesShareStrikesOne) {
  const paper::Corners beyond{{{1, 0, 0}, {0, 0, 1}, {1, 0, 1}}};
  for (int k = 0; k <= 100; ++k) {
    const Vec3 on{k / 100.0, 0, 1 - k / 100.0}, away{0.013, 1, 0.029};
    const bool first = paper::path_hit_outside(on + away, on - away, floor_at(0)).has_value();
    const bool second = paper::path_hit_outside(on + away, on - away, beyond).has_value();
    EXPECT_TRUE(first || second) << k;
  }
}

TEST(Path, StrikesClothThatComesTowardsItFromEitherSide) {
  const Vec3 p{0.2, 0, 0.2};
  const auto from_above = paper::path_hit(p, p, floor_at(-0.1), floor_at(0.1));
  const auto from_below = paper::path_hit(p, p, floor_at(0.3), floor_at(-0.1));
  ASSERT_TRUE(from_above && from_below);
  EXPECT_NEAR(from_above->at, 0.5, 1e-15);
  EXPECT_EQ(from_above->side, 1);
  EXPECT_NEAR(from_below->at, 0.75, 1e-15);
  EXPECT_EQ(from_below->side, -1);
  EXPECT_FALSE(paper::path_hit(p, p + Vec3{0, 0.2, 0}, floor_at(-0.1), floor_at(0.1))) << "it goes along";
}

TEST(Reflection, MirrorsWhatIsLeftOfTheWayAndKeepsItsShare) {
  const Vec3 hit{1, 0, 0}, aim{1.4, -0.2, 0}, up{0, 1, 0};
  EXPECT_EQ(paper::reflected(hit, aim, up, 0), hit) << "it stays where it struck";
  const Vec3 whole = paper::reflected(hit, aim, up, 1), half = paper::reflected(hit, aim, up, 0.5);
  EXPECT_NEAR(whole.x, 1.4, 1e-15);
  EXPECT_NEAR(whole.y, 0.2, 1e-15);
  EXPECT_NEAR(half.x, 1.2, 1e-15);
  EXPECT_NEAR(half.y, 0.1, 1e-15);
}

TEST(HeightSorted, FindsEveryBoxThatOverlapsAndNoOther) {
  std::vector<geometry::Box3> boxes;
  for (int i = 0; i < 200; ++i) {
    const Vec3 low{(i * 37 % 101) / 101.0, (i * 53 % 97) / 97.0, (i * 71 % 89) / 89.0};
    const double tall = 0.02 + 0.3 * (i % 17 == 0);
    boxes.push_back(geometry::box_around({low, low + Vec3{0.1, tall, 0.1}}, 0));
  }
  const paper::HeightSorted sorted(boxes);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p{(i * 29 % 83) / 83.0, (i * 31 % 79) / 79.0, (i * 43 % 73) / 73.0};
    const geometry::Box3 box = geometry::box_around({p}, 0.05);
    std::vector<Index> found, wanted;
    sorted.query(box, [&](Index k) { found.push_back(k); });
    for (Index k = 0; k < 200; ++k)
      if (geometry::overlap(boxes[static_cast<std::size_t>(k)], box)) wanted.push_back(k);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, wanted);
  }
}

TEST(Solids, StandOffByTheirClearanceAndKeepTheirSkin) {
  const std::vector<Vec3> corners{{0, 2, 0}, {0, 2, 1}, {1, 2, 0}};
  const std::vector<Tri> triangles{{0, 1, 2}};
  paper::Solids solids;
  paper::add_solid(corners, triangles, 0.01, solids);
  ASSERT_EQ(solids.triangles.size(), 2u);
  EXPECT_NEAR(solids.triangles[0][0].y, 2.01, 1e-15);
  EXPECT_NEAR(solids.triangles[1][0].y, 2, 1e-15);
  EXPECT_EQ(solids.skin, (std::vector<bool>{false, true}));
}

}  // namespace
}  // namespace toile
