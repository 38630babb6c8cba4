// What a start makes of what a crash left.

#include "server/jobs/recovery.h"

#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using jobs::Fate;
using test::cloth_over_block;
using test::kOwner;
using Log = test::Recorder::JobLog;

store::JobRow cut_off(int attempt, bool draped = false) {
  store::JobRow row;
  row.state = store::JobState::kRunning;
  row.attempt = attempt;
  if (draped) row.verdict = store::JobVerdict{true, "settled", "", ""};
  return row;
}

TEST(Recovery, LeavesWhatIsQueuedOrPausedAsItWas) {
  for (const store::JobState state : {store::JobState::kQueued, store::JobState::kPaused}) {
    store::JobRow row = cut_off(7);
    row.state = state;
    const jobs::Recovery recovery = jobs::recover(row, false, 3);
    EXPECT_EQ(recovery.fate, Fate::kStays);
    EXPECT_EQ(recovery.attempt, 7);
  }
}

TEST(Recovery, CountsACrashOnlyForAJobThatRanAloneAndHasNotComeFurther) {
  EXPECT_EQ(jobs::recover(cut_off(2), true, 1).fate, Fate::kGoesOn);
  EXPECT_EQ(jobs::recover(cut_off(2), true, 1).attempt, 0);
  EXPECT_EQ(jobs::recover(cut_off(3), false, 2).fate, Fate::kGoesAlone) << "it may have been the other";
  EXPECT_EQ(jobs::recover(cut_off(3), false, 2).attempt, 2);
  EXPECT_EQ(jobs::recover(cut_off(2), false, 1).fate, Fate::kGoesAlone);
  EXPECT_EQ(jobs::recover(cut_off(2), false, 1).attempt, 2);
}

TEST(Recovery, GivesUpAfterThreeCrashesAloneAndKeepsWhatHasBeenDraped) {
  EXPECT_EQ(jobs::recover(cut_off(3), false, 1).fate, Fate::kFails);
  EXPECT_EQ(jobs::recover(cut_off(3, true), false, 1).fate, Fate::kWithoutPictures);
  EXPECT_EQ(jobs::recover(cut_off(2, true), false, 1).fate, Fate::kGoesAlone);
}

class RecoveredJobs : public test::JobHouse {
 protected:
  void house(double checkpoint_every_s) {
    settings.checkpoint_every_s = checkpoint_every_s;
    make(2);
    ASSERT_TRUE(service->start().ok());
  }
  /// Two jobs that were running when the server went, each for the third time.
  std::vector<std::string> two_cut_off(double max_time) {
    std::vector<std::string> ids;
    for (const int size : {200, 190}) ids.push_back(submit(cloth_over_block(size, max_time)));
    for (const std::string& id : ids) {
      store.tamper(kOwner, id, [](store::JobRow& row) {
        row.state = store::JobState::kRunning;
        row.attempt = 3;
      });
    }
    return ids;
  }
};

TEST_F(RecoveredJobs, ThatMayHaveCrashedTheServerRunOneAtATimeAndSucceed) {
  const std::vector<std::string> ids = two_cut_off(1);
  house(1e6);
  for (const std::string& id : ids) ASSERT_TRUE(publisher.wait_for_end(id));
  for (const std::string& id : ids) EXPECT_EQ(row(id).state, store::JobState::kSucceeded) << row(id).reason;
  const auto running = [](const test::Recorder::Told& told) {
    return told.progress.state == store::JobState::kRunning;
  };
  const Log first = publisher.log(ids[0]), second = publisher.log(ids[1]);
  const auto last_of_first = std::find_if(first.progress.rbegin(), first.progress.rend(), running);
  const auto first_of_second = std::find_if(second.progress.begin(), second.progress.end(), running);
  ASSERT_TRUE(last_of_first != first.progress.rend() && first_of_second != second.progress.end());
  EXPECT_LT(last_of_first->at, first_of_second->at)
      << "no checkpoint was kept: the first one had to end first";
}

TEST_F(RecoveredJobs, GoOnSideBySideOnceEachHasComeFurther) {
  const std::vector<std::string> ids = two_cut_off(test::kEndless);
  house(0.01);
  const auto steps = [&](const std::string& id) { return service->progress(kOwner, id)->step; };
  // Both are past their turn alone when both run at the same time.
  bool both = false;
  for (int waited = 0; waited < 3000 && !both; ++waited) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    both = service->counts().running == 2 && steps(ids[0]) > 0 && steps(ids[1]) > 0;
  }
  EXPECT_TRUE(both);
}

TEST_F(RecoveredJobs, KeepADrapeWhosePicturesBringTheServerDown) {
  house(1e6);
  const std::string id = submit(cloth_over_block(200));
  store::ResultFiles models;
  store::JobVerdict verdict;
  service->stop();
  store.on_update_job = [&](const store::JobRow& row) {
    if (row.verdict && row.state == store::JobState::kRunning) {
      models = row.results;
      verdict = *row.verdict;
    }
    return Status();
  };
  ASSERT_TRUE(service->start().ok());
  ASSERT_TRUE(publisher.wait(
      id, [](const Log& log) { return !log.ended.empty() && store::is_final(log.ended.back().state); }));
  service->stop();
  ASSERT_TRUE(models.contains("final.glb") && models.contains("report.json"));
  EXPECT_FALSE(models.contains("front.png"));
  store.tamper(kOwner, id, [&](store::JobRow& row) {  // as if the third drawing had crashed
    row.state = store::JobState::kRunning;
    row.attempt = 3;
    row.results = models;
    row.verdict = verdict;
    row.notes.clear();
  });
  ASSERT_TRUE(service->start().ok());
  const store::JobRow job = row(id);
  EXPECT_EQ(job.state, store::JobState::kSucceeded);
  EXPECT_EQ(job.reason_code, "time") << "what the drape came to";
  ASSERT_EQ(job.notes.size(), 1u);
  EXPECT_EQ(job.notes[0].code, "stills.not_drawn");
  EXPECT_EQ(job.results, models);
  EXPECT_FALSE(job.report.empty());
  EXPECT_FALSE(job.verdict.has_value());
}

}  // namespace
}  // namespace toile
