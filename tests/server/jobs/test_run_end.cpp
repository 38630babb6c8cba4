#include "server/jobs/run_end.h"

#include <gtest/gtest.h>

#include <set>

namespace toile {
namespace {

jobs::RunEnd verdict(drape::Stop kind, const std::string& name = "", double gap = 0) {
  drape::DrapeResult result;
  result.stop_reason = {kind, name, gap};
  result.simulated_time = 2.5;
  return jobs::verdict_on(drape::DrapeInput{}, result);
}

TEST(RunEnd, RestAndTimeAreSuccessesAlsoWithAnOpenSeam) {
  for (const drape::Stop kind : drape::kStops) {
    const bool good =
        kind == drape::Stop::kSettled || kind == drape::Stop::kTime || kind == drape::Stop::kOpenSeam;
    EXPECT_EQ(verdict(kind).succeeded, good) << drape::to_string(drape::StopReason{kind, "", 0});
  }
}

TEST(RunEnd, EveryStopHasACodeOfItsOwnAndWords) {
  std::set<std::string> codes;
  for (const drape::Stop kind : drape::kStops) {
    const jobs::RunEnd end = verdict(kind, drape::has_name(kind) ? "left" : "");
    EXPECT_FALSE(end.reason.empty());
    codes.insert(end.code);
  }
  EXPECT_EQ(codes.size(), drape::kStops.size());
}

TEST(RunEnd, ClothAtRestWithAnOpenSeamIsToldAsThatWithTheSeamAndHowFarItIsOpen) {
  const jobs::RunEnd end = verdict(drape::Stop::kOpenSeam, "side_left", 4.24e-3);
  EXPECT_TRUE(end.succeeded) << "the rest of it is draped";
  EXPECT_EQ(end.code, "open_seam");
  EXPECT_EQ(end.where, "seam side_left");
  EXPECT_NE(end.reason.find("came to rest after 2.50 s with the seam still 4.2 mm open"), std::string::npos)
      << end.reason;
}

TEST(RunEnd, ClothAtRestWithAnOpenButtonNamesTheButton) {
  const jobs::RunEnd end = verdict(drape::Stop::kOpenButton, "cuff", 12e-3);
  EXPECT_EQ(end.code, "drape.open_button");
  EXPECT_EQ(end.where, "button cuff");
  EXPECT_NE(end.reason.find("12.0 mm"), std::string::npos) << end.reason;
}

}  // namespace
}  // namespace toile
