// What does not close from where its pieces stand is put on instead.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>

#include "core/drape/drape_session.h"
#include "core/drape/drape_start.h"
#include "core/drape/pipeline.h"
#include "tests/core/arrange/garments.h"
#include "tests/core/dressing/dressed_person.h"

namespace toile {
namespace {

/// A tube_as_broad_as of `breadth` mm in front and behind around the mannequin's hips, which are 945 mm
/// around, sewn at its sides; of firm cloth.
drape::DrapeInput tube_as_broad_as(double breadth) {
  drape::DrapeInput input;
  const std::vector<Vec2> corners{
      {-breadth / 2, 0}, {breadth / 2, 0}, {breadth / 2, 260}, {-breadth / 2, 260}};
  input.pattern.panels = {test::polygon("front", corners), test::polygon("back", corners)};
  input.pattern.seams = {test::seam("left", {{0, 1}}, {{1, 3}}), test::seam("right", {{0, 3}}, {{1, 1}})};
  input.fabrics.resize(1);
  input.fabrics[0].stretch_weft = input.fabrics[0].stretch_warp = 4000;
  input.fabric_of_panel = {0, 0};
  const double height = test::person().figure.waist - 0.28;
  input.placements = {sewing::RigidPlacement{{0, height, 0.2}, {}, false},
                      sewing::RigidPlacement{{0, height, -0.2}, {0, 3.14159265358979, 0}, false}};
  input.bodies = {*test::person().body};
  input.settings.particle_distance = 0.04;
  return input;
}

bool begun_anew(const drape::DrapeResult& r) {
  return std::any_of(r.findings.begin(), r.findings.end(), [](const preflight::Finding& f) {
    return f.kind == preflight::FindingKind::kBegunAnew;
  });
}

/// Threads are not strong enough to close it around the hips.
drape::DrapeInput too_tight() {
  drape::DrapeInput input = tube_as_broad_as(400);
  input.settings.max_time = 2.6;
  return input;
}

TEST(BegunAnew, ASeamThatStaysOpenFromWhereThePiecesStandIsShutByPuttingOn) {
  drape::DrapeInput input = too_tight();
  const drape::DrapeResult r = drape::drape(input, {}, nullptr).value();
  EXPECT_TRUE(begun_anew(r));
  EXPECT_TRUE(r.open_seams.empty());
  EXPECT_EQ(r.worn, drape::Worn::kYes);
  EXPECT_EQ(r.worst.cloth_body + r.worst.cloth_cloth, 0);
  EXPECT_GT(r.simulated_time, input.settings.max_time) << "time counts on";

  input.settings.dress = false;
  const drape::DrapeResult sewn = drape::drape(input, {}, nullptr).value();
  EXPECT_FALSE(begun_anew(sewn)) << "who wants it sewn from there gets what comes of that";
  EXPECT_FALSE(sewn.open_seams.empty());
}

double mean_height(std::span<const Vec3> x) {
  double sum = 0;
  for (const Vec3 p : x) sum += p.y;
  return sum / static_cast<double>(x.size());
}

TEST(BegunAnew, TightClothThatWasPutOnDoesNotRideUp) {
  const drape::DrapeInput input = too_tight();
  const drape::DrapeStart start = drape::prepare_start(input, {}).value();
  const drape::PutOnTries tries = drape::put_on_after(drape::kSewnInPlace, input, start, {});
  ASSERT_TRUE(tries.on.has_value());
  const auto session = drape::DrapeSession::start(input, start.meshes, start.placed, tries.on->positions);
  EXPECT_EQ(session->positions(), tries.on->positions);
  Crew alone;
  while (session->time() < 0.5) session->step(alone);
  EXPECT_NEAR(mean_height(session->positions()), mean_height(tries.on->positions), 0.01);
}

TEST(BegunAnew, WhatClosesFromWhereItStandsIsNot) {
  EXPECT_FALSE(begun_anew(drape::drape(tube_as_broad_as(520), {}, nullptr).value()));
}

TEST(BegunAnew, EndsInTheSameBytesHoweverOftenItIsBrokenOff) {
  const drape::DrapeInput input = too_tight();
  const drape::DrapeResult whole = drape::drape(input, {}, nullptr).value();
  auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  while (!run->done()) {
    run->advance(1300, {});
    run = drape::DrapeRun::resume(input, run->checkpoint(), {}, nullptr).value();
  }
  const drape::DrapeResult cut = run->conclude();
  EXPECT_EQ(cut.positions, whole.positions);
  EXPECT_EQ(cut.steps, whole.steps);
  EXPECT_TRUE(begun_anew(cut)) << "a checkpoint remembers why";
}

TEST(BegunAnew, ACancelWhileItIsPutOnLosesNothing) {
  const drape::DrapeInput input = too_tight();
  std::atomic<bool> cancel{false};
  RunContext context;
  context.cancel = &cancel;
  context.on_progress = [&](const Progress& p) { cancel = p.phase == "dress"; };
  const auto run = drape::DrapeRun::start(input, context, nullptr).value();
  run->advance(std::numeric_limits<int>::max(), context);
  EXPECT_TRUE(cancel) << "it was put on";
  EXPECT_FALSE(run->done());
  EXPECT_EQ(run->advance(1, context), 0);
  run->advance(std::numeric_limits<int>::max(), {});
  EXPECT_EQ(run->conclude().positions, drape::drape(input, {}, nullptr)->positions);
}

}  // namespace
}  // namespace toile
