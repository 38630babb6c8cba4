// Bodies that move while cloth hangs on them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"
#include "tests/core/drape/runs.h"

namespace toile {
namespace {

/// The column under the tablecloth gets so much wider within a second.
drape::DrapeInput on_a_growing_column(double times) {
  drape::DrapeInput input = test::tablecloth();
  test::move_to(input.bodies[0], 1, [&](Vec3 p) { return Vec3{p.x * times, p.y, p.z * times}; });
  return input;
}

Vec3 middle_of(const std::vector<Vec3>& x) {
  Vec3 sum;
  for (const Vec3& p : x) sum += p;
  return sum * (1.0 / static_cast<double>(x.size()));
}

TEST(BodyMotion, AColumnThatGrowsPushesTheClothOutAndItComesToRestAnew) {
  const drape::DrapeInput still = test::tablecloth(), input = on_a_growing_column(1.4);
  const drape::DrapeResult before = draped(still), r = draped(input);
  EXPECT_TRUE(r.settled());
  EXPECT_EQ(crossings_of(r), 0);
  EXPECT_EQ(told(r.findings, preflight::FindingKind::kBodyStopped), nullptr);
  ASSERT_EQ(r.bodies.size(), 1u);
  EXPECT_EQ(r.bodies[0].mesh.vertices, input.bodies[0].motion[0].vertices);
  EXPECT_GT(r.simulated_time, before.simulated_time + 1);
  const auto lowest = [](const drape::DrapeResult& d) {
    return std::min_element(d.positions.begin(), d.positions.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; })
        ->y;
  };
  EXPECT_GT(lowest(r), lowest(before) + 0.01) << "less of it hangs";
}

TEST(BodyMotion, ATableTakesAlongWhatLiesOnIt) {
  const auto moved_by = [](double friction) {
    drape::DrapeInput input = test::tablecloth();
    input.pattern.panels = {test::rectangle("sheet", 100, 100)};
    std::get<sewing::RigidPlacement>(input.placements[0]).translation = {0, 0.301, 0.05};
    input.bodies = {test::column(0.12, 0, 0.3)};  // wider than the sheet, which has no rim to catch on
    input.bodies[0].friction = friction;
    test::move_to(input.bodies[0], 1, [](Vec3 p) { return p + Vec3{0.1, 0, 0}; });
    const drape::DrapeResult r = draped(input);
    EXPECT_EQ(crossings_of(r), 0);
    EXPECT_EQ(r.bodies[0].mesh.vertices, input.bodies[0].motion[0].vertices);
    return middle_of(r.positions).x;
  };
  EXPECT_NEAR(moved_by(0.4), 0.1, 0.005);
  EXPECT_LT(moved_by(0), 0.01) << "without friction it slides away under the cloth";
}

TEST(BodyMotion, ATubeThatIsTooTightStopsTheColumnAndIsNamed) {
  drape::DrapeInput input = test::tube();
  test::move_to(input.bodies[0], 1, [](Vec3 p) { return Vec3{p.x * 2, p.y, p.z * 2}; });
  const drape::DrapeResult r = draped(input);
  EXPECT_EQ(crossings_of(r), 0);
  const preflight::Finding* stopped = told(r.findings, preflight::FindingKind::kBodyStopped);
  ASSERT_NE(stopped, nullptr);
  EXPECT_NE(stopped->message.find("still had"), std::string::npos) << stopped->message;
  ASSERT_EQ(stopped->about.size(), 1u);
  EXPECT_TRUE(stopped->about[0].id == "front" || stopped->about[0].id == "back");
  // The tube is 52 cm around, 44 around the column; woven cloth gives way by 15 %.
  const double radius = r.bodies[0].mesh.vertices[2].z;
  EXPECT_GT(radius, 0.08);
  EXPECT_LT(radius, 1.2 * 0.52 / (2 * 3.14159));
}

TEST(BodyMotion, GoesOnFromACheckpointInItsMidstToTheSameBytes) {
  const drape::DrapeInput input = on_a_growing_column(1.3);
  const drape::DrapeResult whole = draped(input);
  auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  while (run->session().progress().phase != "move") run->advance(10, {});
  run->advance(777, {});
  ASSERT_EQ(run->session().progress().phase, "move");
  auto on = drape::DrapeRun::resume(input, run->checkpoint(), {}, nullptr).value();
  on->advance(1 << 30, {});
  const drape::DrapeResult r = on->conclude();
  EXPECT_EQ(r.steps, whole.steps);
  EXPECT_EQ(r.positions, whole.positions);
  EXPECT_EQ(r.bodies[0].mesh.vertices, whole.bodies[0].mesh.vertices);
}

TEST(BodyMotion, GoesFromShapeToShapeInTime) {
  drape::DrapeInput input = on_a_growing_column(1.2);
  test::move_to(input.bodies[0], 1.5, [](Vec3 p) { return p; });
  const drape::DrapeResult r = draped(input);
  EXPECT_TRUE(r.settled());
  EXPECT_EQ(crossings_of(r), 0);
  EXPECT_EQ(r.bodies[0].mesh.vertices, input.bodies[0].mesh.vertices);
}

TEST(BodyMotion, BeginsAtOnceInTrueMotion) {
  drape::DrapeInput input = on_a_growing_column(1.2);
  input.settings.mode = drape::DrapeMode::kDynamic;
  input.settings.until_settled = false;
  input.settings.max_time = 1.2;
  const drape::DrapeResult r = draped(input);
  EXPECT_EQ(crossings_of(r), 0);
  EXPECT_NEAR(r.simulated_time, 1.2, 0.2);
  EXPECT_EQ(r.bodies[0].mesh.vertices, input.bodies[0].motion[0].vertices);
}

TEST(BodyMotion, ThePapersMethodTellsThatItsBodiesStandStill) {
  drape::DrapeInput input = on_a_growing_column(1.2);
  input.settings.method = drape::DrapeMethod::kPaper;
  input.settings.max_time = 0.1;
  const drape::DrapeResult r = draped(input);
  const preflight::Finding* without = told(r.findings, preflight::FindingKind::kMethodWithout);
  ASSERT_NE(without, nullptr);
  EXPECT_NE(without->message.find("bodies that move"), std::string::npos);
  EXPECT_EQ(r.bodies[0].mesh.vertices, input.bodies[0].mesh.vertices);
}

}  // namespace
}  // namespace toile
