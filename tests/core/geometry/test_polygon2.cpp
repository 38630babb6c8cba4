#include "core/geometry/polygon2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace toile {
namespace {

const std::vector<Vec2> kSquare{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

std::optional<geometry::Crossing> crossing(std::vector<Vec2> loop) {
  const std::vector<std::vector<Vec2>> loops{std::move(loop)};
  return geometry::find_crossing(loops);
}

TEST(Polygon2, AreaIsPositiveCounterClockwiseAndKeepsItsDigitsFarFromTheOrigin) {
  EXPECT_DOUBLE_EQ(geometry::signed_area(kSquare), 100);
  EXPECT_DOUBLE_EQ(geometry::signed_area(std::vector<Vec2>{{0, 0}, {0, 10}, {10, 0}}), -50);
  EXPECT_DOUBLE_EQ(geometry::signed_area(
                       std::vector<Vec2>{{1e9, 1e9}, {1e9 + 1, 1e9}, {1e9 + 1, 1e9 + 1}, {1e9, 1e9 + 1}}),
                   1);
  EXPECT_EQ(geometry::signed_area(std::vector<Vec2>{}), 0);
}

TEST(Polygon2, BoxesHoldTheirPointsAndMeasureDistance) {
  const Aabb2 box = bounding_box(std::vector<Vec2>{{3, 1}, {-2, 5}, {0, 0}});
  EXPECT_EQ(box.low, (Vec2{-2, 0}));
  EXPECT_EQ(box.high, (Vec2{3, 5}));
  EXPECT_EQ(geometry::distance(box, {0, 2}), 0);
  EXPECT_DOUBLE_EQ(geometry::distance(box, {6, 9}), 5);
  EXPECT_TRUE(box.grown(5).contains(Vec2{6, 9}));
}

TEST(Polygon2, PointsAreInsideByTheEvenOddRule) {
  EXPECT_TRUE(geometry::contains(kSquare, {5, 5}));
  EXPECT_FALSE(geometry::contains(kSquare, {11, 5}));
  EXPECT_FALSE(geometry::contains(kSquare, {-1, 10}));
  const std::vector<Vec2> u{{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
  EXPECT_FALSE(geometry::contains(u, {4.5, 6}));
  EXPECT_TRUE(geometry::contains(u, {1.5, 6}));
  EXPECT_FALSE(geometry::contains(std::vector<Vec2>{}, {0, 0}));
}

TEST(Polygon2, SegmentsMeetAtCrossingsTouchesAndOverlapsOnly) {
  EXPECT_EQ(geometry::segment_intersection({0, 0}, {2, 2}, {0, 2}, {2, 0}), (Vec2{1, 1}));
  EXPECT_EQ(geometry::segment_intersection({0, 0}, {4, 0}, {1, 0}, {1, 5}), (Vec2{1, 0}));
  EXPECT_TRUE(geometry::segment_intersection({0, 0}, {4, 0}, {3, 0}, {9, 0}));
  EXPECT_FALSE(geometry::segment_intersection({0, 0}, {4, 0}, {5, 0}, {9, 0}));
  EXPECT_FALSE(geometry::segment_intersection({0, 0}, {4, 0}, {0, 1}, {4, 1}));
  EXPECT_FALSE(geometry::segment_intersection({0, 0}, {4, 0}, {5, -1}, {5, 1}));
}

TEST(Polygon2, FlatLinesAreFlat) {
  EXPECT_TRUE(geometry::is_flat(std::vector<Vec2>{{0, 0}, {5, 5}, {2, 2}}, 1e-9));
  EXPECT_FALSE(geometry::is_flat(kSquare, 1));
}

TEST(Polygon2, ASimpleLoopCrossesNowhere) {
  EXPECT_FALSE(crossing(kSquare));
  EXPECT_FALSE(crossing({{0, 0}, {0, 0}, {10, 0}, {10, 10}, {10, 10}, {0, 0}}));
  EXPECT_FALSE(crossing({{0, 0}, {5, 0}, {10, 0}, {10, 10}}));
}

TEST(Polygon2, AFigureOfEightCrossesAtItsWaist) {
  const auto c = crossing({{0, 0}, {10, 10}, {10, 0}, {0, 10}});
  ASSERT_TRUE(c);
  EXPECT_EQ(c->point, (Vec2{5, 5}));
  EXPECT_EQ(c->segment_a, 0u);
  EXPECT_EQ(c->segment_b, 2u);
}

TEST(Polygon2, TouchesSpikesAndPinchesCountAsCrossings) {
  EXPECT_TRUE(crossing({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}})) << "a vertex on a segment";
  EXPECT_TRUE(crossing({{0, 0}, {10, 0}, {20, 0}, {10, 0}, {10, 10}})) << "out and back on one line";
  EXPECT_TRUE(crossing({{0, 0}, {5, 5}, {10, 0}, {10, 10}, {5, 5}, {0, 10}})) << "two vertices in one place";
  EXPECT_TRUE(crossing({{5, 5}, {0, 10}, {0, 0}, {5, 5}, {10, 0}, {10, 10}})) << "a pinch seen from the side";
}

TEST(Polygon2, LoopsThatCrossEachOtherAreFoundAndThoseApartAreNot) {
  std::vector<std::vector<Vec2>> loops{kSquare, {{2, 2}, {2, 4}, {4, 4}}};
  EXPECT_FALSE(geometry::find_crossing(loops));
  loops[1] = {{8, 5}, {12, 5}, {12, 7}, {8, 7}};
  const auto c = geometry::find_crossing(loops);
  ASSERT_TRUE(c);
  EXPECT_EQ(c->loop_a, 0u);
  EXPECT_EQ(c->loop_b, 1u);
  EXPECT_DOUBLE_EQ(c->point.x, 10);
}

bool crosses_by_trying_all(const std::vector<Vec2>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const Vec2 a = p[i], b = p[(i + 1) % n], c = p[j], d = p[(j + 1) % n];
      if (j == i + 1 || (i == 0 && j == n - 1)) {
        const Vec2 shared = j == i + 1 ? b : a, u = j == i + 1 ? a : b, v = j == i + 1 ? d : c;
        if (cross(u - shared, v - shared) == 0 && dot(u - shared, v - shared) > 0) return true;
      } else if (geometry::segment_intersection(a, b, c, d)) {
        return true;
      }
    }
  return false;
}

TEST(Polygon2, TheSweepAgreesWithTryingAllPairsOnDegenerateLoops) {
  // Small whole coordinates make vertical, collinear, touching and coincident cases by the thousand.
  std::mt19937 random(7);
  int crossed = 0, simple = 0;
  for (int round = 0; round < 20000; ++round) {
    const int n = 3 + int(random() % 6), size = 2 + int(random() % 8);
    std::vector<Vec2> loop;
    while (int(loop.size()) < n) {
      const Vec2 p{double(random() % unsigned(size)), double(random() % unsigned(size))};
      if (loop.empty() || loop.back() != p) loop.push_back(p);
    }
    if (loop.front() == loop.back()) loop.pop_back();
    if (loop.size() < 3) continue;
    const bool expected = crosses_by_trying_all(loop);
    (expected ? crossed : simple) += 1;
    std::string text;
    for (Vec2 p : loop) text += "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ")";
    ASSERT_EQ(crossing(loop).has_value(), expected) << text;
  }
  EXPECT_GT(crossed, 2000);
  EXPECT_GT(simple, 2000);
}

TEST(Polygon2, AHundredThousandVerticesAreFewComparisonsEachEvenAsADiagonalComb) {
  std::vector<Vec2> circle, comb;
  const int n = 100'000;
  for (int i = 0; i < n; ++i)
    circle.push_back(
        {1000 * std::cos(2 * 3.14159265358979 * i / n), 1000 * std::sin(2 * 3.14159265358979 * i / n)});
  // Long slanting teeth side by side: every bounding box overlaps every other.
  for (int i = 0; i < n / 2; ++i) {
    comb.push_back({i * 0.02, i * -0.02});
    comb.push_back({i * 0.02 + 1000.01, i * -0.02 + 999.99});
  }
  comb.push_back({2500, -3000});
  comb.push_back({-10, -3000});
  const auto comparisons_each = [](const std::vector<Vec2>& loop, bool crosses) {
    std::size_t compared = 0;
    EXPECT_EQ(geometry::find_crossing({&loop, 1}, &compared).has_value(), crosses);
    return compared / loop.size();
  };
  // A search in a balanced tree of n asks at most 2 log2(n) times, 34 here; all pairs would be 50,000 each.
  EXPECT_LE(comparisons_each(circle, false), 36u);
  EXPECT_LE(comparisons_each(comb, false), 36u);
  std::swap(comb[50'000], comb[50'002]);
  EXPECT_LE(comparisons_each(comb, true), 36u);
}

}  // namespace
}  // namespace toile
