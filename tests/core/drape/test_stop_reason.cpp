#include <gtest/gtest.h>

#include "core/drape/stop_reason.h"

namespace toile {
namespace {

TEST(StopReason, EveryStopHasWordsThatReadBackAsIt) {
  for (std::size_t i = 0; i < drape::kStops.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(drape::kStops[i]), i) << "the list has every stop once, in its order";
    const drape::StopReason reason{drape::kStops[i], drape::has_name(drape::kStops[i]) ? "left side" : "", 0};
    const Result<drape::StopReason> read = drape::stop_reason_from(drape::to_string(reason));
    ASSERT_TRUE(read.ok()) << drape::to_string(reason);
    EXPECT_EQ(read->kind, reason.kind);
    EXPECT_EQ(read->name, reason.name);
  }
}

TEST(StopReason, NoTwoStopsHaveTheSameWords) {
  for (const drape::Stop a : drape::kStops) {
    for (const drape::Stop b : drape::kStops) {
      EXPECT_EQ(drape::to_string({a, "x", 0}) == drape::to_string({b, "x", 0}), a == b);
    }
  }
}

TEST(StopReason, ASeamsNameMayHoldAnything) {
  for (const char* name : {"", " ", "open seam", "settled", "a b  c", "größe"}) {
    const Result<drape::StopReason> read =
        drape::stop_reason_from(drape::to_string({drape::Stop::kOpenSeam, name, 0}));
    ASSERT_TRUE(read.ok()) << name;
    EXPECT_EQ(read->kind, drape::Stop::kOpenSeam);
    EXPECT_EQ(read->name, name);
  }
}

TEST(StopReason, UnknownWordsAreRefusedAndQuotedAsThePlace) {
  for (const char* words :
       {"", "settle", "settled ", "settled x", "open", "open seam", "Open seam a", "time out"}) {
    const Result<drape::StopReason> read = drape::stop_reason_from(words);
    ASSERT_FALSE(read.ok()) << words;
    EXPECT_EQ(read.error().code, "drape.unknown_stop");
    EXPECT_EQ(read.error().where, words);
  }
}

}  // namespace
}  // namespace toile
