#include "core/base/disjoint_sets.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(DisjointSets, AreStoodForByTheirLeastMember) {
  DisjointSets sets(6);
  EXPECT_TRUE(sets.join(5, 3));
  EXPECT_TRUE(sets.join(4, 5));
  EXPECT_EQ(sets.root(4), 3);
  EXPECT_TRUE(sets.join(1, 4));
  EXPECT_EQ(sets.root(5), 1);
  EXPECT_EQ(sets.root(0), 0);
  EXPECT_EQ(sets.root(2), 2);
}

TEST(DisjointSets, SayWhetherTwoWereOneAlready) {
  DisjointSets sets(3);
  sets.join(0, 1);
  sets.join(1, 2);
  EXPECT_FALSE(sets.join(2, 0));
}

TEST(DisjointSets, GrowByOneAndBeginAnew) {
  DisjointSets sets;
  sets.add();
  sets.add();
  sets.join(0, 1);
  sets.add();
  EXPECT_EQ(sets.root(1), 0);
  EXPECT_EQ(sets.root(2), 2);
  sets.reset(2);
  EXPECT_EQ(sets.root(1), 1);
}

}  // namespace
}  // namespace toile
