// Jobs that go on from where another's garment hung.

#include "server/jobs/input.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kOwner;

class GoingOnJobs : public test::JobHouse {
 protected:
  void SetUp() override { ASSERT_TRUE(service->start()); }
  store::JobRow ended(const std::string& project, const std::string& from = "") {
    jobs::JobWish wish;
    wish.from = from;
    const auto made = service->submit(kOwner, project, "", wish);
    EXPECT_TRUE(made) << (made ? "" : made.error().message);
    if (!made) return {};
    EXPECT_TRUE(publisher.wait_for_end(made->id));
    return row(made->id);
  }
};

TEST_F(GoingOnJobs, BeginWithTheClothAsItHungAndKeepItThoughTheOtherJobIsRemoved) {
  const std::string project = project_of(cloth_over_block(200, 0.3));
  const store::JobRow first = ended(project);
  const store::JobRow on = ended(project, first.id);
  EXPECT_NE(on.report.find("start.goes_on"), std::string::npos) << on.report;
  EXPECT_EQ(first.report.find("start.goes_on"), std::string::npos);
  EXPECT_EQ(on.files.at(jobs::kShapeFile).substr(0, 2), "a_");
  ASSERT_TRUE(service->remove(kOwner, first.id));
  EXPECT_TRUE(store.asset_bytes(kOwner, on.files.at(jobs::kShapeFile)));
}

TEST_F(GoingOnJobs, AreRefusedWhereThereIsNothingToGoOnFrom) {
  const std::string project = project_of(cloth_over_block(200, 0.2));
  jobs::JobWish wish;
  wish.from = "j_nobody";
  EXPECT_EQ(service->submit(kOwner, project, "", wish).error().code, "jobs.from");
  wish.from = service->submit(kOwner, project, "")->id;
  ASSERT_TRUE(service->pause(kOwner, wish.from));
  EXPECT_EQ(service->submit(kOwner, project, "", wish).error().code, "jobs.no_shape");
  const store::RequestContext stranger("stranger");
  EXPECT_FALSE(service->submit(stranger, project, "", wish));
}

/// A drape that is edited while it is under way.
class EditedJobs : public GoingOnJobs {
 protected:
  /// Begun, so far that its cloth hangs.
  std::string hanging(const std::string& project) {
    const std::string id = service->submit(kOwner, project, "")->id;
    EXPECT_TRUE(publisher.wait(id, [](const test::Recorder::JobLog& log) {
      return !log.progress.empty() && log.progress.back().progress.phase == "drape" && log.frames.size() > 10;
    }));
    return id;
  }
  /// The same cloth, stiffer: particles stay, wherever they are just now.
  static std::string stiffer(int size, double max_time) {
    std::string document = cloth_over_block(size, max_time);
    const std::string from = "\"bend_warp_un_m\": 10";
    return document.replace(document.find(from), from.size(), "\"bend_warp_un_m\": 30");
  }
  void edit(const std::string& project, const std::string& document) {
    store::ProjectRow row = *store.project(kOwner, project);
    row.document = document;
    ++row.revision;
    ASSERT_TRUE(store.replace_project(kOwner, row, row.revision));
  }
};

TEST_F(EditedJobs, GoOnAsAnotherFromHowTheClothHangs) {
  const std::string project = project_of(cloth_over_block(300, test::kEndless));
  const std::string id = hanging(project);
  edit(project, stiffer(300, 0.5));
  const auto on = service->go_on(kOwner, id, "key");
  ASSERT_TRUE(on) << on.error().message;
  EXPECT_EQ(on->project_revision, row(id).project_revision + 1);
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kCancelled);
  EXPECT_EQ(row(id).reason_code, "superseded");
  EXPECT_EQ(row(id).reason_where, on->id);
  ASSERT_TRUE(publisher.wait_for_end(on->id));
  const store::JobRow job = row(on->id);
  EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
  EXPECT_NE(job.report.find("start.goes_on"), std::string::npos) << job.report;
  EXPECT_EQ(hash_in(job), hash_of_alone(job)) << "its input tells all of it";
  const auto again = service->go_on(kOwner, id, "key");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->id, on->id) << "the same wish makes one job";
}

TEST_F(EditedJobs, GoOnAlsoWhereTheyArePaused) {
  const std::string project = project_of(cloth_over_block(300, test::kEndless));
  const std::string id = hanging(project);
  ASSERT_TRUE(service->pause(kOwner, id));
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  edit(project, stiffer(300, 0.3));
  const auto on = service->go_on(kOwner, id, "");
  ASSERT_TRUE(on) << on.error().message;
  EXPECT_TRUE(on->files.empty()) << "rows are handed out without";
  EXPECT_TRUE(row(on->id).files.contains(jobs::kShapeFile));
  ASSERT_TRUE(publisher.wait_for_end(on->id));
  EXPECT_NE(row(on->id).report.find("start.goes_on"), std::string::npos);
}

TEST_F(EditedJobs, KeepThePinsThatViewersSet) {
  const std::string project = project_of(cloth_over_block(300, test::kEndless));
  const std::string id = hanging(project);
  const auto pins = [](std::size_t count) {
    return [count](const test::Recorder::JobLog& log) {
      return !log.progress.empty() && log.progress.back().progress.pins.size() == count;
    };
  };
  jobs::LiveTouch pin;
  pin.touch.kind = drape::TouchKind::kPin;
  pin.touch.at = {10, {0.2, 0.3, 0.5}};
  ASSERT_TRUE(service->touch(kOwner, id, pin));
  ASSERT_TRUE(publisher.wait(id, pins(1)));
  const Vec3 place = service->progress(kOwner, id)->pins[0].place;
  edit(project, stiffer(300, 0.5));
  const auto on = service->go_on(kOwner, id, "");
  ASSERT_TRUE(on) << on.error().message;
  ASSERT_TRUE(publisher.wait(on->id, pins(1)));
  EXPECT_LT(length(service->progress(kOwner, on->id)->pins[0].place - place), 2e-3);
  ASSERT_TRUE(publisher.wait_for_end(on->id));
  const store::JobRow job = row(on->id);
  EXPECT_NE(job.report.find("start.goes_on"), std::string::npos) << job.report;
  EXPECT_NE(job.report.find("live.touched"), std::string::npos);
  EXPECT_TRUE(job.results.contains("drape.log"));
  EXPECT_EQ(hash_in(job), hash_of_alone(job)) << "its input tells of the pins as well";

  jobs::JobWish wish;  // and once more, from its end
  wish.from = on->id;
  const auto next = service->submit(kOwner, project, "", wish);
  ASSERT_TRUE(next) << next.error().message;
  EXPECT_TRUE(publisher.wait(next->id, pins(1)));
}

/// Whoever is asked may let go of the drape before it looks up.
TEST_F(EditedJobs, GoOnAlsoWhereAStepEndsMeanwhile) {
  const std::string project = project_of(cloth_over_block(300, test::kEndless));
  for (int i = 0; i < 6; ++i) {
    const std::string id = hanging(project);
    ASSERT_TRUE(service->pause(kOwner, id));
    ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
    ASSERT_TRUE(service->step(kOwner, id));
    const auto on = service->go_on(kOwner, id, "");
    ASSERT_TRUE(on) << on.error().message;
    EXPECT_TRUE(row(on->id).files.contains(jobs::kShapeFile));
    ASSERT_TRUE(service->cancel(kOwner, on->id));
  }
}

TEST_F(EditedJobs, BeginFromThePiecesWhereNothingHangsYet) {
  service->stop();  // nobody begins what is submitted now
  make(1);
  ASSERT_TRUE(service->start());
  const std::string busy = hanging(project_of(cloth_over_block(200, test::kEndless)));
  const std::string project = project_of(cloth_over_block(210, test::kEndless));
  const std::string waits = service->submit(kOwner, project, "")->id;
  edit(project, cloth_over_block(220, 0.3));
  const auto on = service->go_on(kOwner, waits, "");
  ASSERT_TRUE(on) << on.error().message;
  EXPECT_FALSE(row(on->id).files.contains(jobs::kShapeFile));
  EXPECT_EQ(row(waits).reason_code, "superseded");
  EXPECT_EQ(row(busy).state, store::JobState::kRunning);
}

TEST_F(EditedJobs, StayAsTheyAreWhereTheProjectCannotBeDraped) {
  const std::string project = project_of(cloth_over_block(300, test::kEndless));
  const std::string id = hanging(project);
  edit(project, "{}");
  EXPECT_FALSE(service->go_on(kOwner, id, ""));
  EXPECT_EQ(row(id).state, store::JobState::kRunning);
  const std::size_t frames = publisher.log(id).frames.size();
  EXPECT_TRUE(publisher.wait_for_frames(id, frames + 2)) << "and drapes on";
  EXPECT_EQ(service->go_on(store::RequestContext("bob"), id, "").error().code, "store.not_found");
  ASSERT_TRUE(service->cancel(kOwner, id));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(service->go_on(kOwner, id, "").error().code, "jobs.state");
}

}  // namespace
}  // namespace toile
