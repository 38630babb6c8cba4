#include "core/geometry/box_groups.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace toile {
namespace {

std::vector<geometry::Box3> scattered(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.5, 0.5);
  std::vector<geometry::Box3> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 p{place(random), place(random), place(random)};
    boxes.push_back(geometry::box_around({p}, 0.04));
  }
  return boxes;
}

using Pairs = std::set<std::pair<Index, Index>>;

/// All that overlap, found the long way.
Pairs overlaps(const std::vector<geometry::Box3>& a, const std::vector<geometry::Box3>& b) {
  Pairs pairs;
  for (Index i = 0; i < static_cast<Index>(a.size()); ++i) {
    for (Index j = 0; j < static_cast<Index>(b.size()); ++j) {
      if (geometry::overlap(a[i], b[j])) pairs.insert({i, j});
    }
  }
  return pairs;
}

TEST(BoxGroups, FindEveryOverlapOnceAlsoAfterRefitting) {
  for (const int count : {1, 7, 8, 9, 250}) {
    std::vector<geometry::Box3> boxes = scattered(count, 3);
    const std::vector<geometry::Box3> others = scattered(120, 4);
    geometry::BoxGroups groups(boxes);
    const geometry::BoxGroups other(others);
    for (const unsigned seed : {3u, 8u}) {
      boxes = scattered(count, seed);
      groups.refit(boxes);
      Pairs self, found, expected;
      groups.self_pairs([&](Index p, Index q) { EXPECT_TRUE(self.insert(std::minmax(p, q)).second); });
      groups.pairs(other, [&](Index p, Index q) { EXPECT_TRUE(found.insert({p, q}).second); });
      for (const auto& [i, j] : overlaps(boxes, boxes)) {
        if (i < j) expected.insert({i, j});
      }
      EXPECT_EQ(self, expected);
      EXPECT_EQ(found, overlaps(boxes, others));
    }
  }
}

TEST(BoxGroups, PartsVisitWhatTheWholeDoesInItsOrder) {
  for (const int count : {1, 9, 250, 900}) {
    const geometry::BoxGroups groups(scattered(count, 3)), other(scattered(120, 4));
    std::vector<std::pair<Index, Index>> self, found;
    groups.self_pairs([&](Index p, Index q) { self.emplace_back(p, q); });
    groups.pairs(other, [&](Index p, Index q) { found.emplace_back(p, q); });
    for (const std::size_t least : {1u, 2u, 13u, 100000u}) {
      std::vector<std::pair<Index, Index>> self_in_parts, found_in_parts;
      for (const geometry::BoxGroups::Part& part : groups.self_parts(least))
        groups.self_pairs_in(part, [&](Index p, Index q) { self_in_parts.emplace_back(p, q); });
      const std::vector<geometry::BoxGroups::Part> parts = groups.parts(other, least);
      for (const geometry::BoxGroups::Part& part : parts)
        groups.pairs_in(part, other, [&](Index p, Index q) { found_in_parts.emplace_back(p, q); });
      EXPECT_EQ(self_in_parts, self);
      EXPECT_EQ(found_in_parts, found);
      if (count == 900 && least == 13) {
        EXPECT_GE(parts.size(), least);
      }
    }
  }
  const geometry::BoxGroups none;
  EXPECT_TRUE(none.self_parts(4).empty());
  EXPECT_TRUE(none.parts(none, 4).empty());
}

TEST(BoxGroups, FindWhatSomeNewBoxesOverlap) {
  std::vector<geometry::Box3> boxes = scattered(250, 3);
  const std::vector<geometry::Box3> elsewhere = scattered(250, 8);
  geometry::BoxGroups groups(boxes);
  const std::vector<Index> changed{2, 3, 77, 249};
  for (const Index p : changed) boxes[p] = elsewhere[p];
  groups.refit(boxes, changed);
  Pairs found;
  for (Index i = 0; i < 250; ++i) groups.query(boxes[i], [&](Index j) { found.insert({i, j}); });
  EXPECT_EQ(found, overlaps(boxes, boxes));
}

TEST(BoxGroups, PassOverBoxesThatHoldNothing) {
  std::vector<geometry::Box3> boxes = scattered(20, 5);
  boxes[3] = boxes[11] = geometry::Box3{};
  const geometry::BoxGroups groups(boxes);
  groups.self_pairs([](Index p, Index q) {
    for (const Index i : {p, q}) EXPECT_TRUE(i != 3 && i != 11);
  });
  geometry::BoxGroups none;
  none.self_pairs([](Index, Index) { ADD_FAILURE(); });
  groups.pairs(none, [](Index, Index) { ADD_FAILURE(); });
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace toile
