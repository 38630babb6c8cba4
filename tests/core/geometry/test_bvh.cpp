#include "core/geometry/bvh.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace toile {
namespace {

std::vector<geometry::Box3> random_boxes(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  std::vector<geometry::Box3> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 p{place(random), place(random), place(random)};
    boxes.push_back(geometry::box_around(
        {p, p + Vec3{0.1 * place(random), 0.1 * place(random), 0.1 * place(random)}}, 0));
  }
  return boxes;
}

using Pairs = std::set<std::pair<Index, Index>>;

TEST(Bvh, FindsEveryOverlapOnceAlsoAfterRefitting) {
  auto boxes = random_boxes(200, 1);
  const auto others = random_boxes(150, 2);
  geometry::Bvh tree(boxes), other(others);
  for (int round = 0; round < 2; ++round) {
    Pairs self, pairs, self_expected, expected;
    int visits = 0;
    tree.self_pairs([&](Index a, Index b) {
      self.insert(std::minmax(a, b));
      ++visits;
    });
    EXPECT_EQ(visits, static_cast<int>(self.size()));
    tree.pairs(other, [&](Index a, Index b) { EXPECT_TRUE(pairs.insert({a, b}).second); });
    for (Index i = 0; i < 200; ++i) {
      std::set<Index> queried;
      tree.query(boxes[i], [&](Index j) { queried.insert(j); });
      for (Index j = 0; j < 200; ++j) EXPECT_EQ(queried.count(j) == 1, geometry::overlap(boxes[i], boxes[j]));
      for (Index j = i + 1; j < 200; ++j) {
        if (geometry::overlap(boxes[i], boxes[j])) self_expected.insert({i, j});
      }
      for (Index j = 0; j < 150; ++j) {
        if (geometry::overlap(boxes[i], others[j])) expected.insert({i, j});
      }
    }
    EXPECT_EQ(self, self_expected);
    EXPECT_EQ(pairs, expected);
    boxes = random_boxes(200, 9);
    tree.refit(boxes);
  }
}

TEST(Bvh, FindsWhatSomeNewBoxesOverlap) {
  std::vector<geometry::Box3> boxes = random_boxes(200, 3);
  const std::vector<geometry::Box3> elsewhere = random_boxes(200, 9);
  geometry::Bvh tree(boxes);
  const std::vector<Index> changed{0, 7, 8, 150, 199};
  for (const Index p : changed) boxes[p] = elsewhere[p];
  tree.refit(boxes, changed);
  for (Index i = 0; i < 200; ++i) {
    std::set<Index> queried, expected;
    tree.query(boxes[i], [&](Index j) { queried.insert(j); });
    for (Index j = 0; j < 200; ++j) {
      if (geometry::overlap(boxes[i], boxes[j])) expected.insert(j);
    }
    EXPECT_EQ(queried, expected);
  }
}

TEST(Bvh, BoxesHoldTheirPointsInSpiteOfFloats) {
  const Vec3 p{1.7000000123, -0.3000000456, 5.1};
  const geometry::Box3 b = geometry::box_around({p}, 0);
  EXPECT_LE(b.lo[0], p.x);
  EXPECT_GE(b.hi[0], p.x);
  EXPECT_LE(b.lo[2], p.z);
  EXPECT_GE(b.hi[1], p.y);
}

TEST(Bvh, AnEmptyTreeFindsNothing) {
  const geometry::Bvh tree;
  tree.self_pairs([](Index, Index) { FAIL(); });
  tree.query(geometry::Box3{}, [](Index) { FAIL(); });
}

}  // namespace
}  // namespace toile
