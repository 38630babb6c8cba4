#include <gtest/gtest.h>

#include "core/drape/stop_reason.h"

namespace toile {
namespace {

TEST(StopReason, EveryStopHasWordsThatReadBackAsIt) {
  for (std::size_t i = 0; i < kStops.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kStops[i]), i) << "the list has every stop once, in its order";
    const StopReason reason{kStops[i], has_name(kStops[i]) ? "left side" : "", 0};
    const Result<StopReason> read = stop_reason_from(to_string(reason));
    ASSERT_TRUE(read.ok()) << to_string(reason);
    EXPECT_EQ(read->kind, reason.kind);
    EXPECT_EQ(read->name, reason.name);
  }
}

TEST(StopReason, NoTwoStopsHaveTheSameWords) {
  for (const Stop a : kStops) {
    for (const Stop b : kStops) {
      EXPECT_EQ(to_string({a, "x", 0}) == to_string({b, "x", 0}), a == b);
    }
  }
}

TEST(StopReason, ASeamsNameMayHoldAnything) {
  for (const char* name : {"", " ", "open seam", "settled", "a b  c", "größe"}) {
    const Result<StopReason> read = stop_reason_from(to_string({Stop::kOpenSeam, name, 0}));
    ASSERT_TRUE(read.ok()) << name;
    EXPECT_EQ(read->kind, Stop::kOpenSeam);
    EXPECT_EQ(read->name, name);
  }
}

TEST(StopReason, UnknownWordsAreRefusedAndQuotedAsThePlace) {
  for (const char* words :
       {"", "settle", "settled ", "settled x", "open", "open seam", "Open seam a", "time out"}) {
    const Result<StopReason> read = stop_reason_from(words);
    ASSERT_FALSE(read.ok()) << words;
    EXPECT_EQ(read.error().code, "drape.unknown_stop");
    EXPECT_EQ(read.error().where, words);
  }
}

}  // namespace
}  // namespace toile
