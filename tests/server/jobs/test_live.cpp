// Hands on the cloth of jobs under way, and one frame at a time.

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>

#include "core/drape/hands.h"
#include "core/manifest/touch_log.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using drape::Touch;
using drape::TouchKind;
using test::cloth_over_block;
using test::kEndless;
using test::kOwner;

/// s; long enough for hands to come to it, and over in a second once they let go.
constexpr double kWhile = 20;

class LiveJobs : public test::JobHouse {
 protected:
  using Log = test::Recorder::JobLog;

  std::string begun(double max_time) {
    const std::string id = submit(cloth_over_block(200, max_time));
    EXPECT_TRUE(publisher.wait_for_frames(id, 2));
    return id;
  }
  static jobs::LiveTouch pull(int hand, Vec3 to, std::uint32_t epoch = 1) {
    return {epoch, {0, TouchKind::kPull, hand, {10, {0.2, 0.3, 0.5}}, to}, {}};
  }
  static jobs::LiveTouch pin() { return {1, {0, TouchKind::kPin, 0, {10, {0.2, 0.3, 0.5}}, {}}, {}}; }
  static jobs::LiveTouch just(TouchKind kind, int id) { return {0, {0, kind, id, {}, {}}, {}}; }
  bool wait_for(const std::string& id, const std::function<bool(const jobs::JobProgress&)>& holds) {
    return publisher.wait(
        id, [&](const Log& log) { return !log.progress.empty() && holds(log.progress.back().progress); });
  }
  bool wait_for_pulls(const std::string& id, int pulls) {
    return wait_for(id, [&](const jobs::JobProgress& p) { return p.pulls == pulls; });
  }
  std::string refusal(const std::string& id, jobs::LiveTouch touch,
                      const store::RequestContext& who = kOwner) {
    const Status taken = service->touch(who, id, std::move(touch));
    return taken ? "taken" : taken.error().code;
  }
};

TEST_F(LiveJobs, AreTouchedWhileTheyDrapeAndLeaveALogThatDrapesTheSameAgain) {
  settings.engine = "engine";
  make(1);
  ASSERT_TRUE(service->start());
  const std::string id = begun(kWhile);
  ASSERT_TRUE(service->touch(kOwner, id, pull(3, {0.2, 0.4, 0.1})));
  ASSERT_TRUE(wait_for_pulls(id, 1));
  ASSERT_TRUE(service->touch(kOwner, id, pull(3, {-0.2, 0.3, 0.3})));
  ASSERT_TRUE(service->touch(kOwner, id, pin()));
  ASSERT_TRUE(wait_for(id, [](const jobs::JobProgress& p) { return p.pins.size() == 1; }));
  ASSERT_TRUE(service->touch(kOwner, id, just(TouchKind::kLetGo, 3)));
  ASSERT_TRUE(service->touch(kOwner, id, just(TouchKind::kUnpin, 1)));
  ASSERT_TRUE(publisher.wait_for_end(id));
  const store::JobRow job = row(id);
  ASSERT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
  EXPECT_TRUE(job.input.empty()) << "it answers for no other drape";
  EXPECT_NE(job.report.find("live.touched"), std::string::npos);
  EXPECT_EQ(publisher.log(id).ended.back().cloth_body, 0);

  ASSERT_TRUE(job.results.contains("drape.log"));
  const auto touches = manifest::parse_touch_log(*store.result_bytes(kOwner, id, "drape.log"));
  ASSERT_TRUE(touches) << touches.error().message;
  EXPECT_EQ(touches->front().kind, TouchKind::kPull);
  EXPECT_EQ(touches->back().kind, TouchKind::kUnpin);
  EXPECT_NE(hash_in(job), hash_of_alone(job)) << "without hands it hangs elsewhere";
  const drape::DrapeInput input = jobs::drape_input_of(documents, kOwner, job.document, job.files).value();
  const auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  ASSERT_TRUE(run->replay(*touches));
  run->advance(1 << 30, {});
  EXPECT_EQ(hash_of(run->conclude().positions), hash_in(job));
}

TEST_F(LiveJobs, ThatNobodyTouchesLeaveNoLog) {
  ASSERT_TRUE(service->start());
  const std::string id = begun(1);
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_FALSE(row(id).results.contains("drape.log"));
  EXPECT_EQ(hash_in(row(id)), hash_of_alone(row(id)));
}

TEST_F(LiveJobs, TakePinsWhileTheyArePausedAndTellThemAtOnce) {
  ASSERT_TRUE(service->start());
  const std::string id = begun(kEndless);
  ASSERT_TRUE(service->pause(kOwner, id));
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  ASSERT_TRUE(service->touch(kOwner, id, pin()));
  ASSERT_TRUE(wait_for(id, [](const jobs::JobProgress& p) { return p.pins.size() == 1; }));
  const auto told = service->progress(kOwner, id);
  ASSERT_TRUE(told);
  ASSERT_EQ(told->pins.size(), 1u);
  EXPECT_EQ(told->pins[0].number, 1);
  EXPECT_NEAR(told->pins[0].place.y, 0.1, 0.1);
  EXPECT_EQ(row(id).state, store::JobState::kPaused);
  ASSERT_TRUE(service->touch(kOwner, id, just(TouchKind::kUnpin, 1)));
  EXPECT_TRUE(wait_for(id, [](const jobs::JobProgress& p) { return p.pins.empty(); }));
}

TEST_F(LiveJobs, SayWhyTheyTakeNoHands) {
  make(1);
  ASSERT_TRUE(service->start());
  const std::string id = begun(kEndless);
  EXPECT_EQ(refusal(id, pin(), store::RequestContext("bob")), "store.not_found");
  EXPECT_EQ(refusal("j_none", pin()), "store.not_found");
  const std::string waits = submit(cloth_over_block(210));
  EXPECT_EQ(refusal(waits, pin()), "jobs.state");

  std::mutex mutex;
  std::vector<std::string> told;
  const auto telling = [&](jobs::LiveTouch touch) {
    touch.refused = [&](const Error& error) {
      const std::lock_guard lock(mutex);
      told.push_back(error.code);
    };
    return touch;
  };
  ASSERT_TRUE(service->touch(kOwner, id, telling(pull(1, {}, 99))));
  jobs::LiveTouch beside = telling(pin());
  beside.touch.at.triangle = 1 << 20;
  ASSERT_TRUE(service->touch(kOwner, id, beside));
  ASSERT_TRUE(service->touch(kOwner, id, telling(just(TouchKind::kUnpin, 5))));
  ASSERT_TRUE(service->touch(kOwner, id, pin()));
  ASSERT_TRUE(wait_for(id, [](const jobs::JobProgress& p) { return p.pins.size() == 1; }));
  {
    const std::lock_guard lock(mutex);
    EXPECT_EQ(told, (std::vector<std::string>{"live.epoch", "live.point", "live.no_pin"}));
  }
  ASSERT_TRUE(service->cancel(kOwner, id));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(refusal(id, pin()), "jobs.state");
}

TEST_F(LiveJobs, AreInHandAlsoWhileTheyWaitForAWorkerAgain) {
  make(1);
  ASSERT_TRUE(service->start());
  const std::string id = begun(kEndless);
  ASSERT_TRUE(service->touch(kOwner, id, pull(3, {0.2, 0.4, 0.1})));
  ASSERT_TRUE(wait_for_pulls(id, 1));
  ASSERT_TRUE(service->pause(kOwner, id));
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  const std::string other = begun(kEndless);
  const auto resumed = service->resume(kOwner, id);
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->state, store::JobState::kQueued) << "the only worker has the other";
  EXPECT_EQ(refusal(id, just(TouchKind::kLetGo, 3)), "taken");
  ASSERT_TRUE(service->cancel(kOwner, other));
  EXPECT_TRUE(wait_for_pulls(id, 0));
  const std::string waiting = submit(cloth_over_block(200, kEndless));
  EXPECT_EQ(refusal(waiting, pin()), "jobs.state") << "of what has not begun there is no cloth yet";
}

TEST_F(LiveJobs, AreLetGoOfByWhoHeldThemWhenTheServiceStops) {
  ASSERT_TRUE(service->start());
  const std::string id = begun(kWhile);
  ASSERT_TRUE(service->touch(kOwner, id, pull(8, {0.2, 0.4, 0.1})));
  ASSERT_TRUE(service->touch(kOwner, id, pin()));
  ASSERT_TRUE(wait_for(id, [](const jobs::JobProgress& p) { return p.pins.size() == 1 && p.pulls == 1; }));
  service->stop();
  make(1);
  ASSERT_TRUE(service->start());
  ASSERT_TRUE(publisher.wait_for_end(id, 2));
  const store::JobRow job = row(id);
  EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
  const auto touches = manifest::parse_touch_log(*store.result_bytes(kOwner, id, "drape.log"));
  ASSERT_TRUE(touches);
  ASSERT_EQ(touches->size(), 3u);
  EXPECT_EQ(touches->back().kind, TouchKind::kLetGo);
  const drape::DrapeInput input = jobs::drape_input_of(documents, kOwner, job.document, job.files).value();
  const auto run = drape::DrapeRun::start(input, {}, nullptr).value();
  ASSERT_TRUE(run->replay(*touches));
  run->advance(1 << 30, {});
  EXPECT_EQ(hash_of(run->conclude().positions), hash_in(job)) << "also through a stop";
}

TEST_F(LiveJobs, GoOnByOneFrameAndArePausedAgain) {
  ASSERT_TRUE(service->start());
  const std::string id = begun(kEndless);
  ASSERT_TRUE(service->pause(kOwner, id));
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  for (int i = 0; i < 3; ++i) {
    const int step = service->progress(kOwner, id)->step;
    const std::size_t told = publisher.log(id).progress.size();
    ASSERT_TRUE(service->step(kOwner, id));
    ASSERT_TRUE(publisher.wait(id, [&](const Log& log) {
      return log.progress.size() > told && log.progress.back().progress.state == store::JobState::kPaused;
    }));
    const int now = service->progress(kOwner, id)->step;
    EXPECT_EQ(now, (step / settings.stream_interval + 1) * settings.stream_interval);
    EXPECT_EQ(publisher.log(id).frames.back()->step, now) << "and it was shown";
    EXPECT_EQ(row(id).state, store::JobState::kPaused);
  }
  ASSERT_TRUE(service->resume(kOwner, id));
  const std::size_t frames = publisher.log(id).frames.size();
  EXPECT_TRUE(publisher.wait_for_frames(id, frames + 5)) << "a step's end does not hold what is resumed";
}

TEST_F(LiveJobs, MakeTheirStepAlsoWhereItIsAskedForBeforeTheWorkerHasLetGo) {
  ASSERT_TRUE(service->start());
  const std::string id = begun(kEndless);
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(service->pause(kOwner, id));
    ASSERT_TRUE(service->step(kOwner, id)) << "the worker may still have it";
    ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
    for (int look = 0; look < 6000 && row(id).state != store::JobState::kPaused; ++look)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_EQ(row(id).state, store::JobState::kPaused) << "it ran on, round " << i;
    ASSERT_TRUE(service->resume(kOwner, id));
    ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kRunning));
  }
}

TEST_F(LiveJobs, MakeNoStepWhereTheyAreNotPaused) {
  ASSERT_TRUE(service->start());
  const std::string id = begun(kEndless);
  EXPECT_EQ(service->step(kOwner, id).error().code, "jobs.state");
  EXPECT_EQ(service->step(kOwner, "j_none").error().code, "store.not_found");
  const std::size_t frames = publisher.log(id).frames.size();
  EXPECT_TRUE(publisher.wait_for_frames(id, frames + 5)) << "it runs on";
}

TEST(TouchInbox, KeepsTheNewestPlaceOfAHandThatDrawsOn) {
  jobs::TouchInbox inbox;
  for (const double y : {1.0, 2.0, 3.0})
    ASSERT_TRUE(inbox.put({1, {0, TouchKind::kPull, 7, {5, {1, 0, 0}}, {0, y, 0}}, {}}));
  const auto waiting = inbox.take();
  ASSERT_EQ(waiting.size(), 1u);
  EXPECT_EQ(waiting[0].touch.target.y, 3);
  EXPECT_TRUE(inbox.take().empty());
}

TEST(TouchInbox, TakesNoMoreThanItMayAndNothingOnceItIsClosed) {
  jobs::TouchInbox inbox;
  std::vector<std::string> told;
  const auto pin = [&] {
    return jobs::LiveTouch{1, {0, TouchKind::kPin, 0, {5, {1, 0, 0}}, {}}, [&](const Error& error) {
                             told.push_back(error.code);
                           }};
  };
  for (std::size_t i = 0; i < jobs::TouchInbox::kMost; ++i) ASSERT_TRUE(inbox.put(pin()));
  EXPECT_EQ(inbox.put(pin()).error().code, "live.busy");
  EXPECT_TRUE(inbox.put({0, {0, TouchKind::kLetGo, 1, {}, {}}, {}})) << "letting go is always heard";
  inbox.close();
  EXPECT_EQ(told.size(), jobs::TouchInbox::kMost);
  EXPECT_EQ(told[0], "live.over");
  EXPECT_EQ(inbox.put(pin()).error().code, "live.over");
}

}  // namespace
}  // namespace toile
