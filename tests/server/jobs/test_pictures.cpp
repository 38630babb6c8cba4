// Jobs whose drape has ended and whose pictures are being drawn.

#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kOwner;
using Log = test::Recorder::JobLog;

class JobsInTheirPictures : public test::JobHouse {
 protected:
  /// A job whose pictures take a while, and are just being drawn.
  std::string drawing() {
    settings.still_width = 640;
    settings.still_height = 800;
    make(1);
    EXPECT_TRUE(service->start().ok());
    const std::string id = submit(cloth_over_block(200));
    EXPECT_TRUE(publisher.wait(id, [](const Log& log) {
      return !log.progress.empty() && log.progress.back().progress.phase == "stills";
    }));
    return id;
  }
};

TEST_F(JobsInTheirPictures, AreCancelledWithoutWaitingForThem) {
  const std::string id = drawing();
  ASSERT_TRUE(service->cancel(kOwner, id).ok());
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kCancelled);
  EXPECT_TRUE(row(id).results.empty());
  EXPECT_FALSE(store.result_bytes(kOwner, id, "report.json").ok());
}

TEST_F(JobsInTheirPictures, ArePausedAndResumedThere) {
  const std::string id = drawing();
  ASSERT_TRUE(service->pause(kOwner, id).ok());
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  ASSERT_TRUE(service->resume(kOwner, id).ok());
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kSucceeded);
  EXPECT_EQ(row(id).results.size(), 15u);
  EXPECT_EQ(publisher.log(id).topologies.size(), 1u) << "nothing is draped again";
}

/// Whoever edits meanwhile loses neither the edit nor what has been draped.
TEST_F(JobsInTheirPictures, AreGoneOnFromAndGetThemAllTheSame) {
  const std::string id = drawing();
  ASSERT_TRUE(service->pause(kOwner, id).ok());
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  const auto on = service->go_on(kOwner, id, "");
  ASSERT_TRUE(on) << on.error().message;
  EXPECT_TRUE(row(on->id).files.contains(jobs::kShapeFile));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kSucceeded) << row(id).reason;
  EXPECT_EQ(row(id).results.size(), 15u);
  ASSERT_TRUE(publisher.wait_for_end(on->id));
  EXPECT_NE(row(on->id).report.find("start.goes_on"), std::string::npos);
}

TEST_F(JobsInTheirPictures, AreBroughtToTheirEndByAStop) {
  const std::string id = drawing();
  service->stop();
  EXPECT_EQ(row(id).state, store::JobState::kSucceeded);
  EXPECT_EQ(row(id).results.size(), 15u);
}

TEST_F(JobsInTheirPictures, AreKeptWithoutThemWhenTheyCannotBeDrawn) {
  settings.still_width = 4;  // less than a still may have
  service = jobs::make_job_service(documents, publisher, settings);
  ASSERT_TRUE(service->start().ok());
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  const store::JobRow job = row(id);
  EXPECT_EQ(job.state, store::JobState::kSucceeded);
  EXPECT_EQ(job.reason_code, "time");
  EXPECT_NE(job.reason.find("no pictures"), std::string::npos) << job.reason;
  EXPECT_TRUE(job.results.contains("final.glb"));
  EXPECT_FALSE(job.results.contains("front.png"));
}

}  // namespace
}  // namespace toile
