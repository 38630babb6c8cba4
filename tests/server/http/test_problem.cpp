#include "server/http/problem.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Problem, EveryKindOfErrorHasItsStatus) {
  const std::pair<ErrorKind, int> statuses[] = {
      {ErrorKind::kInput, 422},         {ErrorKind::kMalformed, 400}, {ErrorKind::kTooLarge, 413},
      {ErrorKind::kNotFound, 404},      {ErrorKind::kConflict, 409},  {ErrorKind::kStale, 412},
      {ErrorKind::kUnconditional, 428}, {ErrorKind::kTooMany, 429},   {ErrorKind::kUnavailable, 503},
      {ErrorKind::kNoRoom, 507},        {ErrorKind::kCancelled, 500}, {ErrorKind::kSystem, 500},
      {ErrorKind::kInternal, 500}};
  EXPECT_EQ(std::size(statuses), static_cast<std::size_t>(ErrorKind::kInternal) + 1) << "all of them";
  for (const auto& [kind, status] : statuses) {
    EXPECT_EQ(http::status_of(kind), status);
    EXPECT_NE(http::status_phrase(status), "Status") << status << " has a phrase";
  }
}

TEST(Problem, ACodeSaysNothingOfTheStatus) {
  EXPECT_EQ(http::problem(Error{"store.not_found", "", ""}).status, 422);
  EXPECT_EQ(http::problem(Error{"anything", "", "", ErrorKind::kNotFound}).status, 404);
}

}  // namespace
}  // namespace toile
