#include "server/jobs/limits.h"

#include "server/jobs/figures.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kEndless;
using test::kOwner;

class JobLimitsTest : public test::JobHouse {};

TEST_F(JobLimitsTest, AGarmentOfTooManyParticlesIsRefusedWhenItIsSubmitted) {
  settings.limits.particles = 30;
  make(1);
  const auto refused = service->submit(kOwner, project_of(cloth_over_block(200)), "");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "limits.particles");
  EXPECT_EQ(refused.error().where, "/document/settings/particle_distance_mm");
  EXPECT_TRUE(service->submit(kOwner, project_of(cloth_over_block(100)), ""));
}

TEST_F(JobLimitsTest, ADrapeThatTakesTooManyStepsFailsAndSaysSo) {
  settings.limits.steps = 500;
  make(1);
  ASSERT_TRUE(service->start());
  const std::string id = submit(cloth_over_block(200, kEndless));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kFailed);
  EXPECT_EQ(row(id).reason_code, "limits.steps");
  EXPECT_FALSE(store.checkpoint(kOwner, id)) << "nothing goes on from it";
}

TEST_F(JobLimitsTest, ADrapeThatTakesTooMuchTimeFailsAlsoWhereItWasCutOffBetween) {
  settings.limits.work_s = 0.4;
  settings.checkpoint_every_s = 0.05;
  make(1);
  const std::string id = submit(cloth_over_block(400, kEndless));
  store.tamper(kOwner, id, [](store::JobRow& row) { row.worked_ms = 300; });  // by a server of before
  ASSERT_TRUE(service->start());
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kFailed);
  EXPECT_EQ(row(id).reason_code, "limits.time");
  EXPECT_GE(row(id).worked_ms, 400);
  EXPECT_LT(row(id).worked_ms, 3000);
}

TEST_F(JobLimitsTest, WithinThemADrapeEndsAsItWouldWithout) {
  settings.limits = {.work_s = 600, .steps = 100'000, .particles = 10'000};
  make(1);
  ASSERT_TRUE(service->start());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kSucceeded) << row(id).reason;
  EXPECT_EQ(hash_in(row(id)), hash_of_alone(row(id)));
}

TEST_F(JobLimitsTest, WhatADrapeCostStandsInItsRowAndByPhaseInTheFigures) {
  ASSERT_TRUE(service->start());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  service->stop();
  const jobs::JobService::Counts counts = service->counts();
  EXPECT_GT(row(id).worked_ms, 0);
  EXPECT_GT(counts.work_s.at("drape"), 0);
  EXPECT_GT(counts.work_s.at("stills"), 0);
  double all = 0;
  for (const auto& [phase, seconds] : counts.work_s) all += phase == "stills" ? 0 : seconds;
  EXPECT_NEAR(all, static_cast<double>(row(id).worked_ms) / 1000, 0.1 * all + 0.01);
  EXPECT_EQ(counts.run.count(), 1);
  EXPECT_EQ(counts.wait.count(), 1);
}

TEST_F(JobLimitsTest, TheOldestThatWaitsIsKnown) {
  EXPECT_EQ(service->counts().oldest_queued_s, 0);
  ASSERT_TRUE(service->start());
  for (int i = 0; i < 3; ++i) submit(cloth_over_block(200, kEndless));  // one more than there are workers
  EXPECT_GT(service->counts().oldest_queued_s, 0);
}

TEST(Histogram, CountsEachValueUpToItsBoundAndAllBeyond) {
  jobs::Histogram times;
  for (const double seconds : {0.05, 0.1, 0.2, 50.0, 1e6}) times.add(seconds);
  EXPECT_EQ(times.up_to(0), 2) << "the bound itself belongs to it";
  EXPECT_EQ(times.up_to(1), 3);
  EXPECT_EQ(times.up_to(jobs::Histogram::kBounds.size() - 1), 4);
  EXPECT_EQ(times.count(), 5);
  EXPECT_DOUBLE_EQ(times.sum(), 1'000'050.35);
}

}  // namespace
}  // namespace toile
