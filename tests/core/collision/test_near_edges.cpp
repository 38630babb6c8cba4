#include "core/collision/near_edges.h"

#include <gtest/gtest.h>

#include <random>

#include "core/geometry/distance.h"

namespace toile {
namespace {

double gap_of(const collision::EdgeLine& a, const collision::EdgeLine& b) {
  const Vec3 p1 = a.start + a.way, q1 = b.start + b.way;
  const geometry::EdgePoints at = geometry::closest_on_edges(a.start, p1, b.start, q1);
  return length(a.start + a.way * at.s - b.start - b.way * at.t);
}

/// Edges of a few millimetres within a centimetre, of every kind: askew, parallel, in line, without length.
std::vector<collision::EdgeLine> random_lines(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> place(-0.005, 0.005), reach(0.0, 0.002);
  std::vector<collision::EdgeLine> lines;
  for (int i = 0; i < count; ++i) {
    const Vec3 from{1 + place(random), place(random), place(random)};
    Vec3 to = from + Vec3{place(random), place(random), place(random)};
    if (i % 7 == 1) to = from;
    if (i % 7 == 3) to = from + lines.back().way * 0.5;
    if (i % 7 == 5) to = {to.x, from.y, from.z};
    lines.push_back(collision::edge_line(from, to, reach(random)));
  }
  return lines;
}

TEST(NearEdges, KeepsEveryPairWithinReachAndHardlyAnyOther) {
  std::mt19937 random(5);
  const std::vector<collision::EdgeLine> mine = random_lines(random, 141), theirs = random_lines(random, 127);
  std::vector<collision::EdgePair> pairs, expected, kept;
  int surplus = 0;
  for (Index i = 0; i < 141; ++i) {
    for (Index j = 0; j < 127; ++j) {
      pairs.emplace_back(i, j);
      const double reach = mine[i].reach + theirs[j].reach;
      if (gap_of(mine[i], theirs[j]) < reach) expected.emplace_back(i, j);
    }
  }
  collision::visit_near(pairs, mine, theirs, [&](Index i, Index j) {
    const bool within = gap_of(mine[i], theirs[j]) < mine[i].reach + theirs[j].reach;
    surplus += !within && mine[i].squared > 0 && theirs[j].squared > 0;
    if (within) kept.emplace_back(i, j);
  });
  EXPECT_EQ(kept, expected);
  EXPECT_EQ(surplus, 0);
  EXPECT_GT(expected.size(), 1000U);
  EXPECT_LT(expected.size(), pairs.size() / 2);
}

TEST(NearEdges, LooksAtTheLastOfAnOddNumberOfPairsOnce) {
  const std::vector<collision::EdgeLine> lines{collision::edge_line({0, 0, 0}, {1, 0, 0}, 0.1),
                                               collision::edge_line({0, 0.1, 0}, {1, 0.1, 0}, 0.1)};
  const std::vector<collision::EdgePair> pairs{{0, 1}, {1, 0}, {0, 1}};
  int visits = 0;
  collision::visit_near(pairs, lines, lines, [&](Index, Index) { ++visits; });
  EXPECT_EQ(visits, 3);
  collision::visit_near(std::span<const collision::EdgePair>{}, lines, lines,
                        [&](Index, Index) { ++visits; });
  EXPECT_EQ(visits, 3);
}

}  // namespace
}  // namespace toile
