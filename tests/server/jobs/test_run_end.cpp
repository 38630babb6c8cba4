#include "server/jobs/run_end.h"

#include <gtest/gtest.h>

#include <set>

namespace toile {
namespace {

RunEnd verdict(Stop kind, const std::string& name = "", double gap = 0) {
  DrapeResult result;
  result.stop_reason = {kind, name, gap};
  result.simulated_time = 2.5;
  return verdict_on(DrapeInput{}, result);
}

TEST(RunEnd, OnlyRestAndTimeAreSuccesses) {
  for (const Stop kind : kStops) {
    EXPECT_EQ(verdict(kind).succeeded, kind == Stop::kSettled || kind == Stop::kTime)
        << to_string(StopReason{kind, "", 0});
  }
}

TEST(RunEnd, EveryStopHasACodeOfItsOwnAndWords) {
  std::set<std::string> codes;
  for (const Stop kind : kStops) {
    const RunEnd end = verdict(kind, has_name(kind) ? "left" : "");
    EXPECT_FALSE(end.reason.empty());
    codes.insert(end.code);
  }
  EXPECT_EQ(codes.size(), kStops.size());
}

TEST(RunEnd, ClothAtRestWithAnOpenSeamIsToldAsThatWithTheSeamAndHowFarItIsOpen) {
  const RunEnd end = verdict(Stop::kOpenSeam, "side_left", 4.24e-3);
  EXPECT_FALSE(end.succeeded);
  EXPECT_EQ(end.code, "drape.open_seam");
  EXPECT_EQ(end.where, "seam side_left");
  EXPECT_NE(end.reason.find("came to rest after 2.50 s with the seam still 4.2 mm open"), std::string::npos)
      << end.reason;
}

TEST(RunEnd, ClothAtRestWithAnOpenButtonNamesTheButton) {
  const RunEnd end = verdict(Stop::kOpenButton, "cuff", 12e-3);
  EXPECT_EQ(end.code, "drape.open_button");
  EXPECT_EQ(end.where, "button cuff");
  EXPECT_NE(end.reason.find("12.0 mm"), std::string::npos) << end.reason;
}

TEST(RunEnd, AStalledSeamKeepsItsCodeAndPlace) {
  const RunEnd end = verdict(Stop::kStalledSeam, "neck", 30e-3);
  EXPECT_EQ(end.code, "drape.stalled_seam");
  EXPECT_EQ(end.where, "seam neck");
}

}  // namespace
}  // namespace toile
