// The two modes: `drape`, where only the end matters, and `dynamic`, where time is true.

#include <gtest/gtest.h>

#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

/// A sheet in the air with nothing under it.
drape::DrapeInput falling(drape::DrapeMode mode, double seconds) {
  drape::DrapeInput input = test::tablecloth();
  input.bodies.clear();
  input.settings.mode = mode;
  input.settings.until_settled = false;
  input.settings.max_time = seconds;
  return input;
}

double fallen(const drape::DrapeInput& input) {
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(r.stop_reason.kind, drape::Stop::kTime);
  double sum = 0;
  for (const Vec3& p : r.positions) sum += p.y;
  return 0.305 - sum / static_cast<double>(r.positions.size());
}

TEST(Modes, InDynamicASheetFallsAsEverythingDoes) {
  EXPECT_NEAR(fallen(falling(drape::DrapeMode::kDynamic, 0.4)), 0.5 * 9.81 * 0.16, 3e-3);
}

TEST(Modes, InDynamicOnlyTheAirSlowsASheet) {
  drape::DrapeInput input = falling(drape::DrapeMode::kDynamic, 1.0);
  input.fabrics[0].areal_mass = 0.2;
  input.settings.air.density = 1.2;
  // v' = g − v² g / u², u the terminal speed: the way is u²/g · ln cosh(g t / u).
  const double u = std::sqrt(2 * 0.2 * 9.81 / (1.2 * 1.2)),
               way = u * u / 9.81 * std::log(std::cosh(9.81 / u));
  EXPECT_NEAR(fallen(input) / way, 1, 0.03);
}

TEST(Modes, InDrapeGravityComesInSlowly) {
  EXPECT_LT(fallen(falling(drape::DrapeMode::kDrape, 0.4)), 0.5 * 0.5 * 9.81 * 0.16);
}

TEST(Modes, InDynamicAClothMaySettleToo) {
  drape::DrapeInput input = test::tablecloth();
  input.settings.mode = drape::DrapeMode::kDynamic;
  input.settings.air.density = 1.2;
  input.settings.air.across = 40;  // thick enough to come to rest within seconds
  input.settings.max_time = 20;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_TRUE(r.settled()) << drape::to_string(r.stop_reason);
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
}

TEST(Modes, ADrapeThatIsToTakeItsTimeDoes) {
  drape::DrapeInput input = test::tablecloth();
  input.settings.until_settled = false;
  input.settings.max_time = 3;
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_EQ(r.stop_reason.kind, drape::Stop::kTime);
  EXPECT_NEAR(r.simulated_time, 3, 1e-3);
}

}  // namespace
}  // namespace toile
