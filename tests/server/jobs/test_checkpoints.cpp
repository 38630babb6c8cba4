// Jobs that a stop or a crash cut off go on where they were, and end as if nothing had happened.

#include <chrono>
#include <thread>

#include "core/json/tree.h"
#include "server/movie/film_codec.h"
#include "tests/server/jobs/house.h"

namespace toile {
namespace {

using test::cloth_over_block;
using test::kOwner;

constexpr double kNever = 1e6, kOften = 0.01;  // s

class JobCheckpoints : public test::JobHouse {
 protected:
  void house(int workers, double checkpoint_every_s) {
    settings.checkpoint_every_s = checkpoint_every_s;
    make(workers);
    ASSERT_TRUE(service->start().ok());
  }
  bool wait_for_checkpoints(int count) {
    for (int waited = 0; waited < 3000; ++waited) {
      if (store.checkpoints_put() >= count) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  bool has_checkpoint(const std::string& id) { return store.checkpoint(kOwner, id).ok(); }

  /// As a kill would leave the store: the job running, with the newest checkpoint before it.
  void crash(const std::string& id) {
    const auto kept = store.checkpoint(kOwner, id).value();
    const store::JobRow before = row(id);
    service.reset();
    store.tamper(kOwner, id, [&](store::JobRow& r) {
      r = before;
      r.state = store::JobState::kRunning;
    });
    ASSERT_TRUE(store.put_checkpoint(kOwner, id, kept.bytes).ok());
  }

  /// A drape to its end, cut off by a crash once it had checkpoints.
  void drape_through_a_crash(std::string& id) {
    house(1, kOften);
    id = submit(cloth_over_block(200, 6));
    ASSERT_TRUE(wait_for_checkpoints(3));
    crash(id);
    house(1, kNever);
    ASSERT_TRUE(publisher.wait_for_end(id, 2));
  }

  static int resumed_in(const store::JobRow& job) {
    return static_cast<int>(*json::parse_json(job.report).value().find("resumed")->number());
  }
  /// Of the first frame of a job's newest run.
  int first_step(const std::string& id) {
    int step = -1;
    for (const auto& frame : publisher.log(id).frames) {
      if (frame->seq == 1) step = frame->step;
    }
    return step;
  }
};

TEST_F(JobCheckpoints, AfterACrashADrapeGoesOnFromTheNewestToTheSameBytes) {
  std::string id;
  ASSERT_NO_FATAL_FAILURE(drape_through_a_crash(id));
  const store::JobRow job = row(id);
  EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
  EXPECT_EQ(hash_in(job), hash_of_alone(job));
  EXPECT_EQ(resumed_in(job), 1);
  EXPECT_GT(first_step(id), 0) << "viewers see it where it goes on";
  EXPECT_FALSE(has_checkpoint(id)) << "an ended job needs none";
  const auto counts = service->counts();
  const int steps = static_cast<int>(*json::parse_json(job.report).value().find("steps")->number());
  EXPECT_LE(counts.steps, steps - first_step(id)) << "only what this service has stepped";
}

TEST_F(JobCheckpoints, AFilmOfADrapeThatWentOnIsThatOfAWholeOne) {
  std::string id;
  ASSERT_NO_FATAL_FAILURE(drape_through_a_crash(id));
  ASSERT_EQ(resumed_in(row(id)), 1);
  jobs::JobWish wish;
  wish.anew = true;
  const auto job = service->submit(kOwner, project_of(cloth_over_block(200, 6)), "", wish);
  ASSERT_TRUE(job.ok());
  const std::string whole = job->id;
  ASSERT_TRUE(publisher.wait_for_end(whole));
  ASSERT_EQ(resumed_in(row(whole)), 0);
  const auto film_of = [this](const std::string& of) {
    return store.result_bytes(kOwner, of, movie::kFilmFile).value();
  };
  EXPECT_TRUE(film_of(id) == film_of(whole));
}

TEST_F(JobCheckpoints, AStopKeepsRunningAndPausedDrapesWhereTheyStand) {
  house(1, kNever);
  const std::string parked = submit(cloth_over_block(190, 6));
  ASSERT_TRUE(publisher.wait_for_frames(parked, 3));
  ASSERT_TRUE(service->pause(kOwner, parked).ok());
  ASSERT_TRUE(publisher.wait_for_state(parked, store::JobState::kPaused));
  EXPECT_TRUE(has_checkpoint(parked)) << "a pause may last until the power fails";
  const std::string running = submit(cloth_over_block(200, 6));
  ASSERT_TRUE(publisher.wait_for_frames(running, 3));
  service.reset();
  house(2, kNever);
  EXPECT_EQ(row(parked).state, store::JobState::kPaused);
  ASSERT_TRUE(service->resume(kOwner, parked).ok());
  for (const std::string& id : {parked, running}) {
    ASSERT_TRUE(publisher.wait_for_end(id, 2));
    const store::JobRow job = row(id);
    EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
    EXPECT_EQ(hash_in(job), hash_of_alone(job));
    EXPECT_EQ(resumed_in(job), 1);
    EXPECT_GE(first_step(id), 100) << "it had shown three frames";
  }
}

TEST_F(JobCheckpoints, ADrapeByThePapersMethodStreamsPausesAndGoesOnToTheSameBytes) {
  std::string document = cloth_over_block(200, 120);
  const std::string begin = R"("settings": {)";
  document.replace(document.find(begin), begin.size(), begin + R"("solver": "paper", )");
  house(1, kOften);
  const std::string id = submit(document);
  ASSERT_TRUE(publisher.wait_for_frames(id, 3));
  ASSERT_TRUE(service->pause(kOwner, id).ok());
  ASSERT_TRUE(publisher.wait_for_state(id, store::JobState::kPaused));
  ASSERT_TRUE(has_checkpoint(id));
  service.reset();
  house(1, kNever);
  ASSERT_TRUE(service->resume(kOwner, id).ok());
  ASSERT_TRUE(publisher.wait_for_end(id, 2));
  const store::JobRow job = row(id);
  EXPECT_EQ(job.state, store::JobState::kSucceeded) << job.reason;
  EXPECT_EQ(hash_in(job), hash_of_alone(job));
  EXPECT_EQ(resumed_in(job), 1);
  EXPECT_GT(first_step(id), 0);
}

TEST_F(JobCheckpoints, OneOfNoUseMeansAStartFromTheBeginning) {
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(store.put_checkpoint(kOwner, id, "what the disk gave back").ok());
  house(1, kNever);
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kSucceeded) << row(id).reason;
  EXPECT_EQ(hash_in(row(id)), hash_of_alone(row(id)));
  EXPECT_EQ(resumed_in(row(id)), 0);
  EXPECT_EQ(first_step(id), 0);
  EXPECT_FALSE(has_checkpoint(id));
}

TEST_F(JobCheckpoints, AStoreThatTakesNoneDoesNotDisturbTheDrape) {
  store.on_put_checkpoint = [](const std::string&) {
    return Error{"store.full", "no room", "", ErrorKind::kNoRoom};
  };
  house(1, kOften);
  const std::string id = submit(cloth_over_block(200));
  ASSERT_TRUE(publisher.wait_for_end(id));
  EXPECT_EQ(row(id).state, store::JobState::kSucceeded) << row(id).reason;
  EXPECT_EQ(hash_in(row(id)), hash_of_alone(row(id)));
}

TEST_F(JobCheckpoints, ACancelledJobLeavesNone) {
  house(1, kOften);
  const std::string running = submit(cloth_over_block(200, test::kEndless));
  ASSERT_TRUE(wait_for_checkpoints(2));
  ASSERT_TRUE(service->cancel(kOwner, running).ok());
  ASSERT_TRUE(publisher.wait_for_end(running));
  EXPECT_FALSE(has_checkpoint(running));

  const std::string paused = submit(cloth_over_block(190, test::kEndless));
  ASSERT_TRUE(publisher.wait_for_frames(paused, 2));
  ASSERT_TRUE(service->pause(kOwner, paused).ok());
  ASSERT_TRUE(publisher.wait_for_state(paused, store::JobState::kPaused));
  EXPECT_TRUE(has_checkpoint(paused));
  ASSERT_TRUE(service->cancel(kOwner, paused).ok());
  EXPECT_FALSE(has_checkpoint(paused));
}

TEST_F(JobCheckpoints, AJobThatComesFurtherBetweenCrashesIsTriedOnAndOneThatDoesNotIsNot) {
  house(1, kOften);
  const std::string further = submit(cloth_over_block(200, 6));
  ASSERT_TRUE(wait_for_checkpoints(2));
  crash(further);
  store.tamper(kOwner, further, [](store::JobRow& row) { row.attempt = 3; });
  const std::int64_t kept = store.checkpoint(kOwner, further)->kept_ms;
  store.tamper(kOwner, further, [&](store::JobRow& row) { row.started_ms = kept - 1000; });
  house(1, kNever);
  EXPECT_NE(row(further).state, store::JobState::kFailed);
  ASSERT_TRUE(publisher.wait_for_frames(further, publisher.log(further).frames.size() + 1));
  EXPECT_EQ(row(further).attempt, 1) << "counted anew";
  service.reset();

  store.tamper(kOwner, further, [&](store::JobRow& row) {
    row.state = store::JobState::kRunning;
    row.attempt = 3;
    row.started_ms = kept + 1000000;
  });
  house(1, kNever);
  EXPECT_EQ(row(further).state, store::JobState::kFailed);
  EXPECT_EQ(row(further).reason_code, "jobs.attempts");
  EXPECT_FALSE(has_checkpoint(further));
}

/// Three drapes on so many workers, paused and resumed at random and cut off once: their hashes.
TEST_F(JobCheckpoints, OneTwoAndFourWorkersGiveTheSameBytesHoweverTheyAreDisturbed) {
  std::vector<std::string> expected;
  std::uint32_t random = 7;
  const auto chance = [&] { return (random = random * 1664525u + 1013904223u) >> 16; };
  for (const int workers : {1, 2, 4}) {
    house(workers, kOften);
    std::vector<std::string> ids;
    for (const int size : {160, 175, 190}) ids.push_back(submit(cloth_over_block(size, 1.5)));
    for (int k = 0; k < 12; ++k) {
      const std::string& id = ids[chance() % ids.size()];
      static_cast<void>(service->pause(kOwner, id).ok());  // it may have ended
      std::this_thread::sleep_for(std::chrono::milliseconds(chance() % 20));
      if (k == 6) {
        service.reset();
        house(workers, kOften);
      }
      for (const std::string& any : ids) static_cast<void>(service->resume(kOwner, any).ok());
    }
    for (std::size_t k = 0; k < ids.size(); ++k) {
      ASSERT_TRUE(publisher.wait(ids[k], [&](const test::Recorder::JobLog& log) {
        return !log.ended.empty() && log.ended.back().state == store::JobState::kSucceeded;
      })) << store::name_of(row(ids[k]).state);
      if (expected.size() == k) expected.push_back(hash_of_alone(row(ids[k])));
      EXPECT_EQ(hash_in(row(ids[k])), expected[k]) << workers << " workers, drape " << k;
      EXPECT_FALSE(has_checkpoint(ids[k]));
    }
    service.reset();
  }
}

}  // namespace
}  // namespace toile
