// A drape in several goes.

#include <gtest/gtest.h>

#include <atomic>
#include <limits>

#include "core/drape/pipeline.h"
#include "tests/core/drape/garments.h"

namespace toile {
namespace {

struct Steps final : drape::FrameSink {
  std::vector<int> steps;
  void begin(const sewing::GarmentMesh&) override {}
  void frame(const drape::Frame& f) override { steps.push_back(f.step); }
};

TEST(DrapeRun, GivesTheSameResultHoweverItIsCutIntoGoes) {
  const drape::DrapeInput input = test::tube();
  Steps whole_frames, cut_frames;
  const drape::DrapeResult whole = drape::drape(input, {}, &whole_frames).value();

  const auto run = drape::DrapeRun::start(input, {}, &cut_frames).value();
  int taken = 0;
  for (int go = 1; !run->done(); ++go) {
    const int steps = run->advance(go % 97, {});
    EXPECT_LE(steps, go % 97);
    taken += steps;
  }
  const drape::DrapeResult cut = run->conclude();
  EXPECT_EQ(taken, whole.steps);
  EXPECT_EQ(cut.positions, whole.positions);
  EXPECT_EQ(drape::to_string(cut.stop_reason), drape::to_string(whole.stop_reason));
  EXPECT_EQ(cut.frames_checked, whole.frames_checked);
  EXPECT_EQ(cut_frames.steps, whole_frames.steps);
  EXPECT_EQ(cut_frames.steps.front(), 0);
  EXPECT_GT(cut.cpu_s, 0) << "the times of all goes";
}

TEST(DrapeRun, EndsInTheSameBytesOnAnyNumberOfThreads) {
  drape::DrapeInput input = test::tablecloth();
  input.settings.particle_distance = 0.007;
  input.settings.max_time = 0.4;
  const drape::DrapeResult whole = drape::drape(input, {}, nullptr).value();
  ASSERT_GT(whole.garment.triangles.size(), 2000u) << "or nobody is given a part";
  RunContext context;
  context.threads = 3;
  const auto run = drape::DrapeRun::start(input, context, nullptr).value();
  for (int go = 0; !run->done(); ++go) {  // in goes of whom there is
    context.threads = 1 + go % 4;
    run->advance(400, context);
  }
  const drape::DrapeResult shared = run->conclude();
  EXPECT_EQ(shared.positions, whole.positions);
  EXPECT_EQ(shared.steps, whole.steps);
  EXPECT_EQ(shared.worst.cloth_cloth, whole.worst.cloth_cloth);
  EXPECT_EQ(shared.frames_checked, whole.frames_checked);
}

TEST(DrapeRun, StopsBetweenTwoStepsWhenItIsCancelledAndCanGoOn) {
  drape::DrapeInput input = test::tablecloth();
  input.settings.max_time = 0.5;
  std::atomic<bool> cancel{false};
  RunContext context;
  context.cancel = &cancel;
  const auto run = drape::DrapeRun::start(input, context, nullptr).value();
  cancel = true;
  EXPECT_EQ(run->advance(100, context), 0);
  EXPECT_EQ(run->conclude().stop_reason.kind, drape::Stop::kCancelled);
  cancel = false;
  EXPECT_EQ(run->advance(100, context), 100);
  run->advance(std::numeric_limits<int>::max(), context);
  EXPECT_EQ(run->conclude().positions, drape::drape(input, {}, nullptr)->positions);
}

TEST(DrapeRun, CancelledWhileMeshingHasNothingToShow) {
  const std::atomic<bool> cancel{true};
  RunContext context;
  context.cancel = &cancel;
  EXPECT_EQ(drape::DrapeRun::start(test::tube(), context, nullptr).error().code, "cancelled");
  const Result<drape::DrapeResult> nothing = drape::drape(test::tube(), context, nullptr);
  ASSERT_TRUE(nothing.ok()) << "a cancelled drape is no error";
  EXPECT_EQ(nothing->stop_reason.kind, drape::Stop::kCancelled);
  EXPECT_TRUE(nothing->positions.empty());
}

TEST(DrapeRun, EndsInItsTimeThoughItIsLetGoThen) {
  drape::DrapeInput input = test::tube();
  const auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  while (!run->done() && run->session().state().probe.from.empty()) run->advance(1, {});
  ASSERT_FALSE(run->done());
  drape::DrapeInput shorter = input;
  shorter.settings.max_time = run->session().time() + 0.1;
  const drape::DrapeResult end = drape::drape(shorter, {}, nullptr).value();
  EXPECT_EQ(end.stop_reason.kind, drape::Stop::kTime);
  EXPECT_NEAR(end.simulated_time, shorter.settings.max_time, 2 * input.settings.time_step);
}

}  // namespace
}  // namespace toile
