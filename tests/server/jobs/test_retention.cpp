#include "server/jobs/retention.h"

#include <thread>
#include "tests/server/jobs/house.h"

#include "tests/server/store/store_folder.h"
#include "tests/server/store/update_job.h"

namespace toile {
namespace {

constexpr std::int64_t kDayMs = std::int64_t{24} * 3600 * 1000;

/// A service over a real store, which drapes nothing.
class RetentionTest : public testing::Test {
 protected:
  store::JobRow job(store::JobState state, std::int64_t ended_ms) {
    store::JobRow row = *store->create_job(kMe, some_job("old"), "");
    row.state = state;
    row.ended_ms = ended_ms;
    EXPECT_TRUE(store->put_result(kMe, row.id, "report.json", "{}"));
    row.results["report.json"] = 2;
    EXPECT_TRUE(test::update_job(*store, kMe, row));
    return row;
  }
  jobs::Removed remove(const jobs::RetentionSettings& settings, std::int64_t now_ms) {
    return jobs::remove_old(*store, *service, settings, now_ms, {});
  }

  TemporaryFolder folder;
  std::unique_ptr<store::Store> store = opened(folder.path());
  documents::Documents documents{*store};
  test::Recorder publisher;
  std::unique_ptr<jobs::JobService> service = jobs::make_job_service(documents, publisher, {});
};

TEST_F(RetentionTest, RemovesWhatEndedLongAgoWithItsResultsAndNothingElse) {
  const store::JobRow old = job(store::JobState::kSucceeded, 1 * kDayMs);
  const store::JobRow failed = job(store::JobState::kFailed, 2 * kDayMs);
  const store::JobRow recent = job(store::JobState::kSucceeded, 9 * kDayMs);
  const store::JobRow waits = *store->create_job(kMe, some_job("waits"), "");
  EXPECT_EQ(remove({.jobs_days = 5}, 10 * kDayMs).jobs, 2);
  EXPECT_FALSE(store->job(kMe, old.id));
  EXPECT_FALSE(store->job(kMe, failed.id));
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/results/" + old.id));
  EXPECT_TRUE(store->result_bytes(kMe, recent.id, "report.json"));
  EXPECT_TRUE(store->job(kMe, waits.id));
}

TEST_F(RetentionTest, KeepsForEverUnlessItIsTold) {
  job(store::JobState::kSucceeded, 1);
  const jobs::Removed removed = remove({}, 100'000 * kDayMs);
  EXPECT_EQ(removed.jobs + removed.uploads, 0);
}

TEST_F(RetentionTest, RemovesMoreJobsThanAPageHas) {
  for (int i = 0; i < 230; ++i) job(store::JobState::kCancelled, i + 1);
  EXPECT_EQ(remove({.jobs_days = 1}, 10 * kDayMs).jobs, 230);
}

TEST_F(RetentionTest, RemovesUploadsThatNothingUsesOnceTheyAreOld) {
  const store::AssetRow idle = *store->put_asset(kMe, named("dxf", "idle.dxf"), "1");
  const store::AssetRow used = *store->put_asset(kMe, named("dxf", "used.dxf"), "2");
  store::ProjectRow project = some_project("skirt");
  project.files = {{"used.dxf", used.id}};
  ASSERT_TRUE(store->create_project(kMe, project));
  EXPECT_EQ(remove({.uploads_days = 2}, idle.created_ms + kDayMs).uploads, 0);
  EXPECT_EQ(remove({.uploads_days = 2}, idle.created_ms + 3 * kDayMs).uploads, 1);
  EXPECT_FALSE(store->asset(kMe, idle.id));
  EXPECT_EQ(*store->asset_bytes(kMe, used.id), "2");
}

TEST_F(RetentionTest, AnUploadThatAnOldJobUsedGoesAfterTheJob) {
  const store::AssetRow body = *store->put_asset(kMe, named("body", "b.obj"), "1");
  store::JobRow row = some_job("old");
  row.files = {{"b.obj", body.id}};
  row = *store->create_job(kMe, row, "");
  row.state = store::JobState::kSucceeded;
  row.ended_ms = body.created_ms;
  ASSERT_TRUE(test::update_job(*store, kMe, row));
  const jobs::Removed removed = remove({.jobs_days = 1, .uploads_days = 1}, body.created_ms + 2 * kDayMs);
  EXPECT_EQ(removed.jobs, 1);
  EXPECT_EQ(removed.uploads, 1);
}

TEST_F(RetentionTest, BeginsWithTheServiceAndEndsAtOnce) {
  const store::JobRow old = job(store::JobState::kSucceeded, 1);
  {
    const jobs::Retention retention(*store, *service, {.jobs_days = 1}, {});
    for (int i = 0; i < 3000 && store->job(kMe, old.id); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(store->job(kMe, old.id));
  }  // an hour before it would look again
}

}  // namespace
}  // namespace toile
