#include "core/base/result.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

Result<int> half(int n) {
  if (n % 2 != 0) return Error{"base.odd", "it is odd", "", ErrorKind::kConflict};
  return n / 2;
}

Result<int> quarter(int n) {
  const int once = TRY(half(n));
  return half(once);
}

TEST(Error, IsBadInputUnlessItSaysOtherwise) { EXPECT_EQ((Error{"a.b", "c", ""}).kind, ErrorKind::kInput); }

TEST(Error, KeepsItsKindOnTheWayUp) {
  EXPECT_EQ(*quarter(8), 2);
  EXPECT_EQ(quarter(6).error().kind, ErrorKind::kConflict);
  EXPECT_EQ(quarter(3).error().kind, ErrorKind::kConflict);
}

TEST(Error, SeenFromFurtherUpHasAnotherPlaceAndNothingElse) {
  const Error error = placed_at({"a.b", "c", "line 3", ErrorKind::kTooLarge}, "file x");
  EXPECT_EQ(to_string(error), "a.b: c (file x)");
  EXPECT_EQ(error.kind, ErrorKind::kTooLarge);
}

}  // namespace
}  // namespace toile
