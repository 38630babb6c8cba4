#include "core/base/hash.h"

#include <gtest/gtest.h>

#include <vector>

namespace toile {
namespace {

TEST(Hash, DiffersWithEveryBitAndTheOrder) {
  const std::vector<Vec3> a{{1, 2, 3}, {4, 5, 6}};
  std::vector<Vec3> b = a;
  b[1].z = std::nextafter(6.0, 7.0);
  EXPECT_NE(hash_of(a), hash_of(b));
  EXPECT_NE(hash_of(a), hash_of(std::vector<Vec3>{a[1], a[0]}));
  EXPECT_EQ(hash_of(a).size(), 32u);
}

TEST(Hash, TakesMinusZeroForZero) {
  EXPECT_EQ(hash_of(std::vector<Vec3>{{0.0, -0.0, 0}}), hash_of(std::vector<Vec3>{{-0.0, 0.0, 0}}));
}

}  // namespace
}  // namespace toile
